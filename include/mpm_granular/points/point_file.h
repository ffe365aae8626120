#ifndef mpm_granular_points_point_file_h
#define mpm_granular_points_point_file_h

#include <mpm_granular/points/point_layout.h>

namespace mpm_granular::Points
{
  /**
   * Points with positions and volumes from a file: CSV with a header line
   * x,y[,z],volume, or HDF5 with the data sets 'position' (points x dim) and
   * 'volume' (points).
   */
  template <int dim>
  class PointFile : public PointLayout<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    std::vector<Seed<dim>>
    seeds(const Mesh::BackgroundMesh<dim> &mesh,
          const RegionShape<dim>          &shape,
          const std::string               &input_file) const override;

  private:
    std::string file_name;
  };
} // namespace mpm_granular::Points

#endif
