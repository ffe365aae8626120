#ifndef mpm_granular_mesh_ask_owners_h
#define mpm_granular_mesh_ask_owners_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/types.h>

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

namespace mpm_granular::Mesh
{
  using GlobalIndices = std::vector<dealii::types::global_dof_index>;

  /// The ranks that own some indices. Collective.
  /// @param owned those of this rank.
  inline std::map<unsigned int, GlobalIndices>
  by_owner(const dealii::IndexSet &owned,
           GlobalIndices           indices,
           const MPI_Comm          communicator)
  {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    dealii::IndexSet set(owned.size());
    set.add_indices(indices.begin(), indices.end());
    const auto owners =
      dealii::Utilities::MPI::compute_index_owner(owned, set, communicator);
    std::map<unsigned int, GlobalIndices> result;
    for (unsigned int i = 0; i < indices.size(); ++i)
      result[owners[i]].push_back(indices[i]);
    return result;
  }

  /**
   * What the owners of some indices know of them. Collective.
   *
   * @param owned the indices of this rank.
   * @param answer what this rank knows of one of its own.
   */
  template <class Answer>
  std::map<dealii::types::global_dof_index, Answer>
  ask_owners(
    const dealii::IndexSet &owned,
    const GlobalIndices    &indices,
    const MPI_Comm          communicator,
    const std::function<Answer(const dealii::types::global_dof_index)> &answer)
  {
    using dealii::Utilities::MPI::some_to_some;
    const auto asked = by_owner(owned, indices, communicator);
    std::map<unsigned int, std::vector<Answer>> answers;
    for (const auto &[rank, questions] : some_to_some(communicator, asked))
      for (const auto index : questions)
        answers[rank].push_back(answer(index));

    std::map<dealii::types::global_dof_index, Answer> result;
    for (auto &[rank, of_rank] : some_to_some(communicator, answers))
      for (unsigned int i = 0; i < of_rank.size(); ++i)
        result.emplace(asked.at(rank)[i], std::move(of_rank[i]));
    return result;
  }
} // namespace mpm_granular::Mesh

#endif
