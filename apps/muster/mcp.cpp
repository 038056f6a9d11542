// muster mcp
#include <iostream>
#include <memory>
#include <string>

#include "assistant.h"
#include "commands.h"
#include "studio_link.h"

namespace muster {
namespace {

struct McpOptions {
    std::string studio = "ws://127.0.0.1:8080";
    std::string name = "Assistant";
};

int serve(const McpOptions& options) {
    const auto address = StudioAddress::read(options.studio);
    if (!address.ok()) {
        std::cerr << "muster: " << address.status().message() << "\n";
        return kExitUsage;
    }
    StudioLink link(*address, options.name);
    Assistant assistant(link);
    for (std::string line; std::getline(std::cin, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty()) continue;
        if (const auto answer = assistant.answer(line)) std::cout << *answer << "\n" << std::flush;
    }
    return kExitOk;
}

}  // namespace

void addMcpCommand(CommandLine& line) {
    Subcommand command = line.add("mcp", "Lets a language model direct in a running studio.");
    auto options = std::make_shared<McpOptions>();
    command.option("--studio", options->studio, "Address of the studio.");
    command.option("--name", options->name, "How others in the studio see it.");
    command.footer(
        "It speaks the Model Context Protocol on standard input and output: a program with a language model "
        "starts it.\n"
        "Examples:\n"
        "  muster mcp\n"
        "  muster mcp --studio ws://127.0.0.1:9000");
    command.run([options] { return serve(*options); });
}

}  // namespace muster
