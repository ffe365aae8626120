#include <deal.II/base/config.h>

#include <boost/program_options.hpp>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/version.h>
#include <mpm_granular/parameters/command_line.h>
#include <mpm_granular/parameters/name_distance.h>

#include <algorithm>
#include <sstream>

namespace mpm_granular::Parameters
{
  namespace options = boost::program_options;

  namespace
  {
    options::options_description
    visible_options()
    {
      options::options_description visible("Options");
      auto                         add = visible.add_options();
      add("check",
          "read FILE, set everything up and print the report of what a run "
          "would be, without running or writing");
      add("drive",
          "test one material point as FILE says, for the calibration of a law");
      add("set",
          options::value<std::vector<std::string>>()->value_name(
            "\"SECTION/ENTRY=VALUE\""),
          "use this value instead of the one in FILE; may be repeated");
      add("output",
          options::value<std::string>()->value_name("DIR"),
          "write to this folder: short for --set \"Output/Directory=DIR\"");
      add("overwrite", "replace the files of an earlier run in that folder");
      add("resume",
          options::value<std::string>()->value_name("DIR"),
          "continue the run in this folder from its newest checkpoint; --set "
          "may change the end time, output, observables and checkpoints");
      add("print-parameters",
          options::value<std::string>()->implicit_value("prm")->value_name(
            "FORM"),
          "print all entries with their meaning, as they are by default or as "
          "they are used with FILE; FORM is prm or markdown");
      add("help", "print this text");
      add("version", "print the versions of the program and of its parts");
      return visible;
    }



    options::variables_map
    parse(const int argc, const char *const *argv)
    {
      options::options_description all;
      all.add(visible_options())
        .add_options()("file", options::value<std::vector<std::string>>());
      options::positional_options_description positional;
      positional.add("file", -1);

      using namespace options::command_line_style;
      // Some versions of Boost would take the word after --print-parameters as
      // its form.
      std::vector<std::string> arguments(argv + 1, argv + argc);
      std::replace(arguments.begin(),
                   arguments.end(),
                   std::string("--print-parameters"),
                   std::string("--print-parameters=prm"));

      options::variables_map values;
      options::store(options::command_line_parser(arguments)
                       .options(all)
                       .positional(positional)
                       .style(unix_style & ~allow_guessing)
                       .run(),
                     values);
      return values;
    }



    /// The message of an option that cannot be understood.
    std::string
    explanation(const options::error &error)
    {
      std::string message = error.what();
      if (const auto *unknown =
            dynamic_cast<const options::unknown_option *>(&error))
        {
          std::vector<std::string> names;
          const auto               visible = visible_options();
          for (const auto &option : visible.options())
            names.push_back("--" + option->long_name());
          message = "there is no option '" + unknown->get_option_name() + "'." +
                    did_you_mean(unknown->get_option_name(), names);
        }
      if (message.find_last_of(".?") + 1 != message.size())
        message += ".";
      return "Command line: " + message + " See --help.";
    }



    /// What makes no sense for a run that is continued in its own folder.
    void
    refuse_beside_resume(const CommandLine &line)
    {
      using Task = CommandLine::Task;
      require(line.task != Task::print_parameters,
              "Command line: --resume does not go with --print-parameters; "
              "the parameters are in '" +
                line.resume + "/parameters.prm'.");
      require(line.file.empty(),
              "Command line: --resume takes the parameters from the "
              "checkpoint; leave out '" +
                line.file + "'.");
      require(!line.drive,
              "Command line: --resume does not go with --drive; a test of a "
              "material point is repeated.");
      require(!line.overwrite,
              "Command line: --resume continues a run, --overwrite removes it; "
              "choose one.");
      for (const auto &override : line.overrides)
        require(override.rfind("Output/Directory", 0) != 0,
                "Command line: --resume continues in '" + line.resume +
                  "'; a run cannot go on in another folder.");
    }



    CommandLine
    interpret(const options::variables_map &values)
    {
      CommandLine result;
      using Task = CommandLine::Task;
      if (values.count("help"))
        result.task = Task::show_help;
      else if (values.count("version"))
        result.task = Task::show_version;
      else if (values.count("print-parameters"))
        result.task = Task::print_parameters;
      else if (values.count("check"))
        result.task = Task::check;

      if (values.count("file"))
        {
          const auto files = values["file"].as<std::vector<std::string>>();
          require(files.size() == 1,
                  "Command line: one parameter file is expected, not " +
                    std::to_string(files.size()) + ": " + quoted_list(files) +
                    ". See --help.");
          result.file = files.front();
        }
      if (values.count("resume"))
        result.resume = values["resume"].as<std::string>();
      require(!result.file.empty() || !result.resume.empty() ||
                (result.task != Task::run && result.task != Task::check),
              "Command line: name a parameter file, for example "
              "'mpm_granular wall.prm'. See --help.");

      if (values.count("set"))
        result.overrides = values["set"].as<std::vector<std::string>>();
      if (values.count("output"))
        result.overrides.push_back("Output/Directory=" +
                                   values["output"].as<std::string>());
      result.overwrite = values.count("overwrite") > 0;
      result.drive     = values.count("drive") > 0;
      if (!result.resume.empty())
        refuse_beside_resume(result);

      if (result.task == Task::print_parameters)
        {
          const auto style = values["print-parameters"].as<std::string>();
          require(style == "prm" || style == "markdown",
                  "Command line: --print-parameters can be followed by "
                  "'=prm' or '=markdown', not by '=" +
                    style + "'. See --help.");
          result.print_style =
            style == "prm" ? Style::parameter_file : Style::markdown;
        }
      return result;
    }



    /// The arguments as a shell takes them.
    std::string
    quoted_for_shell(const int argc, const char *const *argv)
    {
      const std::string harmless = "abcdefghijklmnopqrstuvwxyz"
                                   "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                   "0123456789_-+=/.,:@%";
      std::string       text;
      for (int i = 0; i < argc; ++i)
        {
          const std::string argument = argv[i];
          text += i == 0 ? "" : " ";
          if (!argument.empty() &&
              argument.find_first_not_of(harmless) == std::string::npos)
            {
              text += argument;
              continue;
            }
          text += '\'';
          for (const char letter : argument)
            text += letter == '\'' ? "'\\''" : std::string(1, letter);
          text += '\'';
        }
      return text;
    }
  } // namespace



  CommandLine
  parse_command_line(const int argc, const char *const *argv)
  {
    try
      {
        CommandLine result = interpret(parse(argc, argv));
        result.text        = quoted_for_shell(argc, argv);
        return result;
      }
    catch (const options::error &error)
      {
        throw InputError(explanation(error));
      }
  }



  std::string
  usage()
  {
    std::ostringstream text;
    text
      << "mpm_granular: flow of granular material by the material point "
         "method\n\n"
         "Usage:\n"
         "  mpm_granular FILE [options]              run the case in FILE\n"
         "  mpm_granular --check FILE                only check it\n"
         "  mpm_granular --drive FILE [options]      test a material point\n"
         "  mpm_granular --resume DIR [options]      continue the run in "
         "DIR\n"
         "  mpm_granular --print-parameters [FILE]   list all entries\n\n"
      << visible_options()
      << "\nExit code: 0 done, 1 input refused, 2 computation failed, 3 "
         "interrupted by a\nsignal after writing the last state and a checkpoint.\n";
    return text.str();
  }



  std::string
  version_text()
  {
    std::string packages;
#ifdef DEAL_II_WITH_MPI
    packages += " MPI";
#endif
#ifdef DEAL_II_WITH_P4EST
    packages += " p4est";
#endif
#ifdef DEAL_II_WITH_TRILINOS
    packages += " Trilinos";
#endif
#ifdef DEAL_II_WITH_METIS
    packages += " METIS";
#endif
#ifdef DEAL_II_WITH_HDF5
    packages += " HDF5";
#endif
#ifdef DEAL_II_GMSH_WITH_API
    packages += " gmsh";
#endif
    return std::string("mpm_granular ") + Core::version + "\ngit commit " +
           Core::git_hash + "\n" + Core::build_type + ", " + Core::compiler +
           "\ndeal.II " + DEAL_II_PACKAGE_VERSION + " with" + packages + "\n";
  }
} // namespace mpm_granular::Parameters
