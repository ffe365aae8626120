// The folder of a run: refused when occupied, emptied of a run's files only,
// and files in it that are either old or new, never half.

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/output/run_folder.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

using namespace mpm_granular;
namespace fs = std::filesystem;

void
touch(const fs::path &path)
{
  fs::create_directories(path.parent_path());
  std::ofstream(path) << "old";
}



std::string
contents(const fs::path &path)
{
  std::ifstream      file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}



void
print_files(const fs::path &folder)
{
  std::set<std::string> names;
  for (const auto &entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory())
      names.insert(entry.path().lexically_relative(folder).string());
  for (const auto &name : names)
    std::cout << "  " << name << std::endl;
}



void
expect_refusal(const std::string &name, const std::function<void()> &action)
{
  std::cout << name << ": ";
  try
    {
      action();
      std::cout << "allowed" << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}



int
main()
{
  fs::remove_all("place");
  fs::create_directory("place");
  fs::create_directory("place/empty");
  touch("place/file");

  expect_refusal("New", [] { Output::RunFolder("place/new/deep", false); });
  std::cout << "Nothing made yet: " << fs::exists("place/new") << std::endl;
  expect_refusal("Empty", [] { Output::RunFolder("place/empty", false); });
  expect_refusal("No name", [] { Output::RunFolder("", true); });
  expect_refusal("A file", [] { Output::RunFolder("place/file", true); });
  expect_refusal("Below a file",
                 [] { Output::RunFolder("place/file/run", true).prepare(); });

  const Output::RunFolder folder("place/new/deep", false);
  folder.prepare();
  for (const std::string name : {"parameters.prm",
                                 "manifest.json",
                                 "observables.csv",
                                 "profile.csv",
                                 "points.pvd",
                                 "grid.pvd",
                                 "log.txt",
                                 "points/points-00000.vtu",
                                 "points/points-123456.vtu",
                                 "grid/grid-00001.vtu",
                                 "points.xdmf",
                                 "points/points-00003.pvtu",
                                 "points/points-00003-0012.vtu",
                                 "points/points-00004.h5",
                                 "grid.xdmf.tmp",
                                 "grid/grid-00003.pvtu",
                                 "grid/grid-00003-0012.vtu",
                                 "grid/grid-00004.h5",
                                 "checkpoint/step-0000000100.h5",
                                 "checkpoint/step-0000000200.h5.tmp",
                                 "points.pvd.tmp",
                                 "points/points-00002.vtu.tmp"})
    touch(folder.file(name));
  for (const std::string name : {"notes.txt",
                                 "my points.pvd",
                                 "points/points-00000.vtu.bak",
                                 "points/mine.vtu",
                                 "points/points-3.xdmf",
                                 "checkpoint/mine.h5",
                                 "pictures/front.png",
                                 "other/manifest.json"})
    touch(folder.file(name));

  expect_refusal("Occupied",
                 [] { Output::RunFolder("place/new/deep", false); });
  const Output::RunFolder again("place/new/deep", true);
  std::cout << "Untouched before prepare(): "
            << fs::exists(again.file("manifest.json")) << std::endl;
  again.prepare();
  std::cout << "Left:" << std::endl;
  print_files("place/new/deep");

  const std::string file = again.file("manifest.json");
  Output::write_atomically(file, [](std::ostream &out) { out << "first"; });
  std::cout << "Written: " << contents(file) << std::endl;
  Output::write_atomically(file, [&](std::ostream &out) {
    out << "second" << std::flush;
    std::cout << "While it is written again: " << contents(file) << std::endl;
  });
  std::cout << "Then: " << contents(file) << std::endl;
  try
    {
      Output::write_atomically(file, [](std::ostream &out) {
        out << "third";
        throw std::runtime_error("trouble");
      });
    }
  catch (const std::runtime_error &error)
    {
      std::cout << "After " << error.what() << ": " << contents(file)
                << std::endl;
    }
  try
    {
      // A full disk.
      Output::write_atomically(file, [](std::ostream &out) {
        out << "fourth";
        out.setstate(std::ios::badbit);
      });
    }
  catch (const ComputationError &error)
    {
      std::cout << "After a full disk: " << contents(file) << std::endl;
    }
  try
    {
      Output::write_atomically("no/such/folder/file", [](std::ostream &) {});
    }
  catch (const ComputationError &)
    {
      std::cout << "No such folder: refused" << std::endl;
    }
  std::cout << "No temporary file left: " << !fs::exists(file + ".tmp")
            << std::endl;
}
