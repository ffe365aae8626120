// Points from a file: CSV and HDF5 give the same ones; what is wrong in a file
// is named with its line or point.

#include <deal.II/base/hdf5.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/lac/full_matrix.h>

#include "../jittered_box.h"

#include <mpm_granular/points/point_file.h>

#include <fstream>
#include <iostream>

using namespace Test;

void
read(const Mesh::BackgroundMesh<2> &mesh, const std::string &name)
{
  Points::BoxShape<2>  everywhere; // the unit box by default
  Points::PointFile<2> layout;
  ParameterHandler     prm;
  layout.add_parameters(prm);
  prm.parse_input_from_string("set File = " + name);
  layout.check();
  try
    {
      for (const auto &seed : layout.seeds(mesh, everywhere, ""))
        std::cout << seed.position << " in its cell "
                  << (seed.cell == mesh.locate({seed.position})[0])
                  << ", volume " << seed.volume << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Mesh::BackgroundMesh<2>    mesh(JitteredBox<2>(3), "");

  std::ofstream("points.csv") << "x, y, volume\n0.25,0.5,0.125\n\n0.5,0.75,2\n";
  std::cout << "CSV" << std::endl;
  read(mesh, "points.csv");

  {
    HDF5::File         file("points.h5", HDF5::File::FileAccessMode::create);
    FullMatrix<double> position(2, 2);
    position(0, 0) = .25;
    position(0, 1) = .5;
    position(1, 0) = .5;
    position(1, 1) = .75;
    file.write_dataset("position", position);
    file.write_dataset("volume", std::vector<double>{.125, 2.});
  }
  std::cout << "HDF5" << std::endl;
  read(mesh, "points.h5");

  std::ofstream("header.csv") << "x,y\n0.25,0.5\n";
  std::ofstream("short.csv") << "x,y,volume\n0.25,0.5\n";
  std::ofstream("text.csv") << "x,y,volume\n0.25,0.5,much\n";
  std::ofstream("outside.csv") << "x,y,volume\n0.25,0.5,1\n2,0.5,1\n";
  std::ofstream("negative.csv") << "x,y,volume\n0.25,0.5,-1\n";
  for (const char *name :
       {"header.csv", "short.csv", "text.csv", "outside.csv", "negative.csv"})
    read(mesh, name);
}
