#include "app/cli/console/InputOutput.h"
#include "app/cli/options/ShellCompletion.h"
#include "app/cli/verbs/Verb.h"

#include <memory>

namespace rubble {
namespace {

constexpr const char* kCompletionFooter =
    R"(Prints a script by which a shell completes verbs, options and values. Packages install it.

Examples:
  source <(rubble-cli completion bash)
  rubble-cli completion zsh > ~/.zfunc/_rubble-cli
  rubble-cli completion fish > ~/.config/fish/completions/rubble-cli.fish)";

Status printCompletion(CLI::App& program, const std::string& shell, const CliContext& context) {
    const std::vector<CommandTreeVerb> verbs = commandTree(program);
    if (shell == "zsh") return printText(zshCompletion(verbs), context);
    if (shell == "fish") return printText(fishCompletion(verbs), context);
    return printText(bashCompletion(verbs), context);
}

}  // namespace

Verb addCompletion(CLI::App& program) {
    Command command(program, "completion", "Print the completion script of a shell", kCompletionFooter);
    command.hide();
    const auto shell = std::make_shared<std::string>();
    command.argument("SHELL", *shell, "bash, zsh or fish").required().oneOf({"bash", "zsh", "fish"}).valueName(" ");
    return {command, [&program, shell](VerbReport&, const CliContext& context) {
                return printCompletion(program, *shell, context);
            }};
}

}  // namespace rubble
