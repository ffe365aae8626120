#include <deal.II/base/patterns.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/output/output_parameters.h>
#include <mpm_granular/parameters/documentation_handler.h>

namespace mpm_granular::Output
{
  using dealii::Patterns::Double;

  void
  OutputParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Directory",
                      directory,
                      "Folder for all files of the run, made if it is not "
                      "there. One that is not empty is refused unless "
                      "--overwrite is given.");
    prm.add_parameter("Interval",
                      interval,
                      "Simulated time between two files of the points; time "
                      "steps end exactly there. 0: only the first and the last "
                      "state. Units: s.",
                      Double(0.));
    prm.add_parameter("Observables interval",
                      observables_interval,
                      "Simulated time between two rows of observables.csv. 0: "
                      "a row after every time step. Units: s.",
                      Double(0.));
    prm.add_parameter("Progress interval",
                      progress_interval,
                      "Wall time between two lines of progress in a log; a "
                      "terminal renews its line more often. Units: s.",
                      Double(0.));
    prm.add_parameter("Point fields",
                      point_fields,
                      "Fields of the points to write: 'all', or a list of "
                      "velocity, speed, stress, pressure, von_mises_stress, "
                      "volume_ratio, mass, id, material and the names of the "
                      "laws' history. Pressure and stress in Pa, pressure "
                      "positive and stress negative in compression.");
    prm.add_parameter("Every nth point",
                      every_nth_point,
                      "Only the points whose id is a multiple of this are "
                      "written, the same ones at all times. The layout "
                      "'symmetric' numbers the points cell by cell: a number "
                      "that has no factor in common with the points per cell "
                      "takes all places in a cell in turn.",
                      dealii::Patterns::Integer(1));
    prm.add_parameter(
      "Write grid",
      write_grid,
      "Whether the mesh is written beside the points, with mass, "
      "velocity and mean pressure of its nodes.");
    prm.add_parameter(
      "Format",
      format,
      "Files of points and grid. 'VTU': one file per instant, which the first "
      "process writes for all; the record for ParaView is points.pvd. 'PVTU': "
      "several VTU files per instant, written at the same time, with "
      "a PVTU file that names them; points.pvd. 'HDF5': one HDF5 file per "
      "instant, which all processes write together; points.xdmf. It cannot be "
      "changed when a run is continued.",
      dealii::Patterns::Selection("VTU|PVTU|HDF5"));
    Parameters::only_with(prm, "Format", "PVTU", format, [&] {
      prm.add_parameter("Ranks per file",
                        ranks_per_file,
                        "How many processes share a VTU file.",
                        dealii::Patterns::Integer(1));
    });
    prm.add_parameter("Compression",
                      compression,
                      "How much time to spend on small files. 'fast' leaves "
                      "about 0.69 of a VTU file of wall.prm, 0.64 of an HDF5 "
                      "file; a VTU file then takes 41 ms instead of 8 ms (4.1 "
                      "MB, two processes). 'default' and 'best' take longer "
                      "and save hardly more.",
                      dealii::Patterns::Selection("none|fast|default|best"));
  }



  void
  OutputParameters::check() const
  {
    require(!directory.empty(), "Output/Directory is empty.");
    require(!point_fields.empty(),
            "Output/Point fields is empty; 'all' or a list of names is "
            "expected.");
  }



  unsigned int
  OutputParameters::compression_level() const
  {
    return compression == "none" ? 0 :
           compression == "fast" ? 1 :
           compression == "best" ? 9 :
                                   6;
  }
} // namespace mpm_granular::Output
