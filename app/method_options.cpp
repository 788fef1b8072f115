// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/method_options.h"

#include "app/command_error.h"
#include "core/model/blow_traits.h"
#include "core/text/decimal_text.h"

namespace drillwave {

std::vector<OptionSpec> methodOptionSpecs() {
    return {
        {"method", "NAME",
         "solution method: exact, lattice (time steps) or closed_form (default: exact; for a result "
         "file, its own method)"},
        {"segments", "N",
         "number of segments into which the lattice method (time steps) divides the rod (default: 10000)"}};
}

MethodChoice methodChoice(const Arguments& arguments, const std::optional<MethodChoice>& ofResult) {
    MethodChoice choice;
    if (ofResult && !arguments.has("method")) choice = *ofResult;
    const std::string given = arguments.value("method").value_or(std::string(name(choice.method)));
    const std::optional<Method> method = findMethod(given);
    if (!method) {
        std::string known;
        for (const std::string_view one : methodNames())
            known += (known.empty() ? "" : ", ") + std::string(one);
        throw CommandError(ExitCode::usage, Message(translatable("--method %1: is not known; choose from %2"),
                                                    {shortened(given), known}));
    }
    choice.method = *method;
    if (arguments.has("segments") && choice.method != Method::lattice)
        throw CommandError(ExitCode::usage,
                           translatable("--segments applies to the lattice; add --method lattice"));
    choice.lattice.segments = static_cast<int>(
        arguments.number("segments", choice.lattice.segments, minimumSegments, maximumSegments));
    return choice;
}

Message forUniformRods(const std::string& path) {
    return {translatable("%1: is for uniform rods; leave it out for a drill string"), {path}};
}

void checkMethodOfString(const MethodChoice& choice, const Scenario& scenario, const std::string& path) {
    if (!isFollowedByEvents(scenario) && choice.method != Method::exact)
        throw CommandError(ExitCode::usage,
                           about("--method " + std::string(name(choice.method)), forUniformRods(path)));
}

void checkMethodApplies(const MethodChoice& choice, const Scenario& scenario, const std::string& path) {
    checkMethodOfString(choice, scenario, path);
    if (choice.method == Method::exact) return;
    const Message refusal = methodRefusal(choice.method, problemOf(scenario));
    if (!refusal.isEmpty())
        throw CommandError(ExitCode::usage,
                           about("--method " + std::string(name(choice.method)), about(path, refusal)));
}

}  // namespace drillwave
