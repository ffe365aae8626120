// A file with a changed byte is refused, or what is read from it is right (HDF5
// has bytes that mean nothing); a file that was cut off is refused. So is what
// is no checkpoint, of a later format, or lacks something.

#include "state.h"

#include <mpm_granular/core/exceptions.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

using namespace Test;
namespace fs = std::filesystem;

enum class Found
{
  refused,
  right,
  wrong
};



Found
look_at(const std::string &path, const State &expected)
{
  try
    {
      Checkpoint::Reader reader(path, MPI_COMM_SELF);
      State              read;
      read.serialize(reader);
      return read == expected ? Found::right : Found::wrong;
    }
  catch (const InputError &)
    {
      return Found::refused;
    }
}



void
write_file(const std::string &path, const std::string &data)
{
  std::ofstream(path, std::ios::binary) << data;
}



void
print_refusal(const std::string &name, const std::string &path)
{
  std::cout << name << ": ";
  try
    {
      Checkpoint::Reader reader(path, MPI_COMM_SELF);
      double             missing;
      reader.replicated("state/missing", missing);
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

  const State       state = make_state(0, n_rows);
  const std::string path  = "state.h5";
  Checkpoint::write(path, MPI_COMM_SELF, [&](Core::Archive &archive) {
    State copy = state;
    copy.serialize(archive);
  });
  std::cout << "Undamaged is right: " << (look_at(path, state) == Found::right)
            << std::endl
            << "No temporary file: " << !fs::exists(path + ".tmp") << std::endl;

  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  const std::string data = content.str();

  unsigned int n_wrong = 0, n_refused = 0;
  for (std::size_t i = 0; i < data.size(); i += 17)
    {
      std::string changed = data;
      changed[i] ^= 1 << (i % 8);
      write_file("changed.h5", changed);
      const Found found = look_at("changed.h5", state);
      n_wrong += found == Found::wrong;
      n_refused += found == Found::refused;
    }
  std::cout << "Changed and wrong: " << n_wrong << std::endl
            << "Some are refused: " << (n_refused > 10) << std::endl;

  unsigned int n_not_refused = 0;
  for (std::size_t size = 0; size < data.size(); size += data.size() / 50)
    {
      write_file("cut.h5", data.substr(0, size));
      n_not_refused += look_at("cut.h5", state) != Found::refused;
    }
  std::cout << "Cut off and not refused: " << n_not_refused << std::endl;

  write_file("text.h5", "no checkpoint");
  print_refusal("Text", "text.h5");
  print_refusal("No file", "nothing.h5");
  print_refusal("Missing value", path);
  {
    using Core::Hdf5File;
    Hdf5File later("later.h5", Hdf5File::Mode::create, MPI_COMM_SELF);
    later.write_attribute("/",
                          "format_version",
                          Checkpoint::format_version + 1);
  }
  print_refusal("Later format", "later.h5");

  try
    {
      Checkpoint::write("no/such/folder.h5",
                        MPI_COMM_SELF,
                        [](Core::Archive &) {});
    }
  catch (const ComputationError &)
    {
      std::cout << "No folder to write to: refused" << std::endl;
    }
}
