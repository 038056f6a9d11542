// The program's command line: subcommands and their options. The only code that includes CLI11 is
// command_line.cpp, since including it costs seconds of compile time.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace muster {

/// Exit codes, as `muster --help` lists them.
enum ExitCode : int {
    kExitOk = 0,
    kExitFailure = 1,        ///< A file is bad or something went wrong; one sentence on standard error.
    kExitUsage = 2,          ///< The command line is wrong.
    kExitNotReproduced = 3,  ///< A replay gave another hash, or a criterion failed.
};

/// One option of a subcommand. Each function adds a rule and returns the option.
class Option {
public:
    explicit Option(CLI::Option* option) : option_(option) {}

    /// Makes the option required.
    Option& required();
    /// Limits the value to [low, high]. The help text shows the limits of whole numbers as whole numbers.
    Option& range(int low, int high);
    Option& range(double low, double high);
    /// Limits the value to finite numbers in [low, high]. Unlike range() it refuses "nan".
    Option& finite(double low, double high);
    /// Limits the value to these words.
    Option& oneOf(const std::vector<std::string>& words);
    /// Requires the name of an existing folder.
    Option& existingFolder();
    /// Adds a check: `check` returns the error for a value, or an empty text.
    Option& check(const std::function<std::string(const std::string&)>& check);
    /// Requires exactly that many values.
    Option& values(int count);
    /// Sets the character that separates values.
    Option& separatedBy(char character);
    /// Takes one value each time the option is given.
    Option& oneValueEach();
    /// Forbids the option together with `other`.
    Option& excludes(const Option& other);
    /// Allows the option only together with `other`.
    Option& needs(const Option& other);

private:
    CLI::Option* option_;
};

/// One subcommand. Variables that options refer to must live until the command has run.
class Subcommand {
public:
    explicit Subcommand(CLI::App* app, int* exitCode) : app_(app), exitCode_(exitCode) {}

    /// Adds an option ("--name", "-n,--name") or a positional argument ("NAME") that sets `value`.
    Option option(const std::string& name, std::string& value, const std::string& about);
    Option option(const std::string& name, int& value, const std::string& about);
    Option option(const std::string& name, double& value, const std::string& about);
    Option option(const std::string& name, std::vector<std::string>& values, const std::string& about);
    Option option(const std::string& name, std::vector<double>& values, const std::string& about);
    /// Adds a switch: `value` becomes true where it is given.
    Option flag(const std::string& name, bool& value, const std::string& about);
    /// Sets the text below the options in the help text.
    void footer(const std::string& text);
    /// Adds a command of its own; one of these must be named then.
    Subcommand add(const std::string& name, const std::string& about);
    /// Sets the function of the command; it returns the exit code.
    void run(std::function<int()> action);

private:
    CLI::App* app_;
    int* exitCode_;
};

/// The complete command line.
class CommandLine {
public:
    CommandLine(const std::string& name, const std::string& about, const std::string& version,
                const std::string& footer);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// Adds a subcommand.
    Subcommand add(const std::string& name, const std::string& about);
    /// Runs the subcommand that the arguments name, or prints help. Returns the exit code.
    int run(int argc, char** argv);

private:
    std::unique_ptr<CLI::App> app_;
    int exitCode_ = kExitOk;
};

}  // namespace muster
