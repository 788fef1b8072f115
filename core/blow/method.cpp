// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/method.h"

#include "core/text/decimal_text.h"
#include "core/text/enum_names.h"
#include "core/wave/closed/closed_form.h"

namespace drillwave {

namespace {

constexpr EnumNames<Method> names{
    {{Method::exact, "exact"}, {Method::lattice, "lattice"}, {Method::closedForm, "closed_form"}}};

}  // namespace

std::string_view name(Method method) {
    return names[method];
}

std::optional<Method> findMethod(std::string_view name) {
    return names.find(name);
}

std::span<const std::string_view> methodNames() {
    return names.all();
}

Message methodProblem(std::string_view name) {
    if (findMethod(name)) return {};
    std::string list;
    for (const std::string_view known : names.all().first(names.all().size() - 1))
        list += (list.empty() ? "" : ", ") + std::string(known);
    return {translatable("must be %1 or %2"), {list, std::string(names.all().back())}};
}

std::optional<int> segmentsIn(std::string_view text) {
    const std::optional<int> segments = wholeNumberIn<int>(text);
    if (!segments || *segments < minimumSegments || *segments > maximumSegments) return std::nullopt;
    return segments;
}

Message segmentsProblem() {
    return wholeNumberProblem(minimumSegments, maximumSegments);
}

Message nameMessage(Method method) {
    switch (method) {
        case Method::exact:
            return translatable("exact");
        case Method::lattice:
            return translatable("lattice");
        case Method::closedForm:
            return translatable("closed_form");
    }
    return {};
}

Message methodMessage(const MethodChoice& choice) {
    const Message method = nameMessage(choice.method);
    if (choice.method != Method::lattice) return {translatable("method %1"), {method}};
    return {translatable("method %1, %2 segments"), {method, std::to_string(choice.lattice.segments)}};
}

std::string describe(const MethodChoice& choice) {
    return methodMessage(choice).text();
}

Message methodRefusal(Method method, const Problem& problem) {
    return method == Method::closedForm ? closedFormRefusal(problem) : Message();
}

Impact MethodSolver::solve(const Problem& problem, Detail detail, const MethodChoice& choice,
                           const std::stop_token& stop) {
    switch (choice.method) {
        case Method::exact:
            return m_exact.solve(problem, detail, stop);
        case Method::lattice:
            if (!m_lattice) m_lattice.emplace();
            return m_lattice->solve(problem, detail, choice.lattice, stop);
        case Method::closedForm:
            return solveClosedForm(problem, detail);
    }
    return {};
}

ChainSolution MethodSolver::solveString(const Scenario& scenario, NetworkSettings settings,
                                        const std::stop_token& stop) {
    settings.mostCells = m_mostCells;
    return solveChain(scenario, settings, m_strings, stop);
}

}  // namespace drillwave
