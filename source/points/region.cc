#include <deal.II/base/mpi.h>

#include <mpm_granular/points/region.h>

namespace mpm_granular::Points
{
  using namespace dealii;

  template <int dim>
  Region<dim>::Region()
    : material("sand")
    , shape("box")
    , layout("symmetric")
  {}

  template <int dim>
  void
  Region<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Material",
                      material,
                      "Name of the material, one of Materials/Names.");
    shape.add_parameters(prm, "Shape", "The part of space the region fills:");
    layout.add_parameters(prm, "Layout", "How its points are laid out:");
  }

  template <int dim>
  void
  Region<dim>::check() const
  {
    shape->check();
    layout->check();
  }

  template <int dim>
  std::vector<Seed<dim>>
  Region<dim>::fill(const Mesh::BackgroundMesh<dim> &mesh,
                    const std::string               &input_file) const
  {
    shape->attach(mesh);
    std::vector<Seed<dim>> seeds    = layout->seeds(mesh, *shape, input_file);
    bool                   is_empty = seeds.empty();
    if (mesh.is_distributed())
      is_empty =
        Utilities::MPI::max(seeds.size(), mesh.mpi_communicator()) == 0;
    require(!is_empty,
            "A region holds no point: its shape lies outside the mesh or is "
            "smaller than the distance of its points.");
    return seeds;
  }

  template class Region<2>;
  template class Region<3>;
} // namespace mpm_granular::Points
