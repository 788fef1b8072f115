// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave examples [-o DIR] [NAME]…
#include <algorithm>
#include <cstdio>

#include "app/command.h"
#include "app/output_folder.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"
#include "core/yaml/examples.h"

namespace drillwave {

namespace {

const Example& namedExample(const std::string& name) {
    if (const Example* example = findExample(name)) return *example;
    std::vector<std::string_view> names;
    for (const Example& example : builtInExamples()) names.push_back(example.name);
    const std::string near(nearestName(name, names));
    if (near.empty())
        throw CommandError(ExitCode::usage,
                           Message(translatable("`%1` is not an example; `drillwave examples` lists them"),
                                   {shortened(name)}));
    throw CommandError(ExitCode::usage, Message(translatable("`%1` is not an example; did you mean `%2`?"),
                                                {shortened(name), near}));
}

std::vector<Example> chosenExamples(const Arguments& arguments) {
    std::vector<Example> chosen;
    for (const std::string& name : arguments.operands())
        if (std::ranges::find(chosen, name, &Example::name) == chosen.end())
            chosen.push_back(namedExample(name));
    if (chosen.empty()) chosen.assign(builtInExamples().begin(), builtInExamples().end());
    return chosen;
}

void list(const std::vector<Example>& examples, const ReadingStyle& style, OutputFile& out) {
    std::size_t width = 0;
    for (const Example& example : examples) width = std::max(width, example.name.size());
    for (const Example& example : examples)
        out.write(example.name + std::string(width - example.name.size() + 2, ' ') +
                  style.said(Message::ofTable(example.title)) + "\n");
}

/// Prints a stream of YAML documents.
void print(const std::vector<Example>& examples, OutputFile& out) {
    for (const Example& example : examples) {
        if (&example != &examples.front()) out.writeText("---\n");
        out.writeText(example.text);
    }
}

void writeInto(const std::string& directory, const std::vector<Example>& examples, Overwrite overwrite) {
    const Interruption interruption;
    FolderFiles folder;
    for (const Example& example : examples)
        folder.files.push_back({example.name + ".yaml", std::string(example.text)});
    checkFolder(directory, folder.names(), overwrite);
    writeFolder(directory, folder, overwrite, &interruption);
    for (const Example& example : examples)
        std::printf("%s/%s.yaml\n", directory.c_str(), example.name.c_str());
}

ExitCode runExamples(const Arguments& arguments, const Drawing*) {
    const std::vector<Example> examples = chosenExamples(arguments);
    const std::optional<std::string> directory = arguments.value("o");
    if (directory && *directory != "-") {
        writeInto(*directory, examples, arguments.has("force") ? Overwrite::allowed : Overwrite::refused);
        return ExitCode::done;
    }
    if (arguments.has("force"))
        throw CommandError(ExitCode::usage, translatable("--force applies to the files of -o; add -o DIR"));
    OutputFile out("-", Overwrite::allowed);
    if (directory || !arguments.operands().empty())
        print(examples, out);
    else
        list(examples, arguments.style(), out);
    out.commit();
    return ExitCode::done;
}

}  // namespace

const Command& examplesCommand() {
    static const Command command{
        .name = "examples",
        .operands = "[NAME]…",
        .summary = "list the built-in scenarios, print the named ones, or write them into a folder",
        .details = "`drillwave examples t38_string > my.yaml` saves a built-in scenario as a file to edit.",
        .options = {{"o", "DIR", "write the scenarios into DIR, one file each; -o - prints them"},
                    {"force", "", "overwrite existing files"}},
        .leastOperands = 0,
        .mostOperands = SIZE_MAX,
        .draws = [](const Arguments&) { return false; },
        .run = runExamples,
    };
    return command;
}

}  // namespace drillwave
