// The newest checkpoints stay; a damaged one is passed over; what is newer than
// the one a run continues from goes.

#include "state.h"

#include <mpm_granular/checkpoint/checkpoint_folder.h>
#include <mpm_granular/core/exceptions.h>

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace Test;
namespace fs = std::filesystem;

void
print_files(const Checkpoint::CheckpointFolder &folder)
{
  for (const auto &file : folder.files())
    std::cout << "  " << file << std::endl;
}



void
print_newest()
{
  try
    {
      const auto start = Checkpoint::newest_checkpoint("run", MPI_COMM_WORLD);
      std::cout << start.file << ", " << start.parameter_text << ", "
                << start.input_file << std::endl;
      for (const auto &remark : start.remarks)
        std::cout << "  " << remark << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}



int
main(int argc, char **argv)
{
  const Mpi::MPI_InitFinalize mpi(argc, argv, 1);
  fs::remove_all("run");
  print_newest();
  fs::create_directory("run");
  print_newest();

  const Checkpoint::CheckpointFolder folder("run", 3, MPI_COMM_WORLD);
  for (const unsigned int step : {5, 90, 100, 1000, 1500})
    folder.write(step, [&](Core::Archive &archive) {
      std::string text = "step " + std::to_string(step),
                  file = "/home/case.prm";
      Checkpoint::serialize_input(archive, text, file);
    });
  std::cout << "Kept:" << std::endl;
  print_files(folder);
  print_newest();

  fs::resize_file(folder.files().front(), 100);
  print_newest();
  std::ofstream("run/checkpoint/step-0000002000.h5.tmp") << "incomplete";
  std::ofstream("run/checkpoint/notes.txt") << "mine";
  folder.remove_newer_than("run/checkpoint/step-0000001000.h5");
  std::cout << "After going on from step 1000:" << std::endl;
  print_files(folder);
  std::cout << "Incomplete one left: "
            << fs::exists("run/checkpoint/step-0000002000.h5.tmp")
            << ", other file left: " << fs::exists("run/checkpoint/notes.txt")
            << std::endl;

  for (const auto &file : folder.files())
    fs::resize_file(file, 100);
  print_newest();
}
