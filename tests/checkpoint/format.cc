// What is written comes back, bit for bit: on the same processes, each with its
// rows; written by several and read by one; written by one and read by several.
// Checksums do not depend on the number of processes.

#include "state.h"

#include <iostream>

using namespace Test;

/// The part of the rows that a process has: the first one none, if there are
/// others; then unequal parts.
State
local_part(const MPI_Comm comm)
{
  const unsigned int n     = Mpi::n_mpi_processes(comm);
  const unsigned int r     = Mpi::this_mpi_process(comm);
  const auto         first = [&](const unsigned int rank) {
    return rank == n ? n_rows : rank <= 1 ? 0 : (n_rows * rank) / n - 5;
  };
  return n == 1 ? make_state(0, n_rows) : make_state(first(r), first(r + 1));
}



void
say(const std::string &name, const bool condition)
{
  const bool on_all = Mpi::min(condition ? 1 : 0, MPI_COMM_WORLD) == 1;
  if (Mpi::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << name << ": " << (on_all ? "yes" : "no") << std::endl;
}



int
main(int argc, char **argv)
{
  const Mpi::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm              world = MPI_COMM_WORLD;
  const bool                  first = Mpi::this_mpi_process(world) == 0;

  const State written = local_part(world);
  State       copy    = written;
  Checkpoint::write("all.h5", world, [&](Core::Archive &archive) {
    say("Writing is not reading", !archive.is_reading());
    copy.serialize(archive);
  });
  say("Writing changes nothing", copy == written);
  {
    Checkpoint::Reader reader("all.h5", world);
    State              read;
    read.serialize(reader);
    say("Same processes", reader.has_same_ranks() && reader.is_reading());
    say("Read by those who wrote it", read == written);
  }

  const State whole = make_state(0, n_rows);
  bool        good  = true;
  if (first)
    {
      Checkpoint::Reader reader("all.h5", MPI_COMM_SELF);
      State              read;
      read.serialize(reader);
      good = read == whole &&
             reader.has_same_ranks() == (Mpi::n_mpi_processes(world) == 1);

      State again = whole;
      Checkpoint::write("one.h5", MPI_COMM_SELF, [&](Core::Archive &archive) {
        again.serialize(archive);
      });
    }
  say("Read by one", good);

  MPI_Barrier(world);
  {
    Checkpoint::Reader reader("one.h5", world);
    State              read;
    read.serialize(reader);
    say("About as many rows for each",
        read.cell.size() <= n_rows / Mpi::n_mpi_processes(world) + 1);
    double sum = 0.;
    for (const double number : read.position)
      sum += number;
    for (const double number : whole.position)
      sum -= number / Mpi::n_mpi_processes(world);
    say("No row is missing or doubled",
        Mpi::sum(read.cell.size(), world) == n_rows &&
          std::abs(Mpi::sum(sum, world)) < 1e-12);
    say("Replicated values are everywhere",
        read.numbers.size() == 4 && read.text == whole.text);
  }

  const Core::Hdf5File all("all.h5", Core::Hdf5File::Mode::read, world);
  const Core::Hdf5File one("one.h5", Core::Hdf5File::Mode::read, world);
  good = true;
  for (const std::string name : {"points/position",
                                 "points/cell",
                                 "points/material",
                                 "grid/sums",
                                 "state/numbers",
                                 "state/text"})
    good = good && all.read_attribute(name, "checksum") ==
                     one.read_attribute(name, "checksum");
  say("Checksums do not depend on processes", good);
}
