// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/runs.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/archive/result_scenario.h"
#include "core/model/blow_traits.h"
#include "core/model/version.h"
#include "ui/runs/difference_text.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

// A run of a file stays as it was first solved: another result is to be told every time.
std::optional<double> corToKeep(const Run& run) {
    return !run.kept && run.isSolved() ? std::optional(run.blow->summary.cor) : run.kept;
}

std::string versionToKeep(const Run& run) {
    return !run.kept && run.isSolved() ? versionText : run.version;
}

}  // namespace

const Run* Runs::find(int number) const {
    const auto found = std::ranges::find(*m_list, number, &Run::number);
    return found == m_list->end() ? nullptr : &*found;
}

const Run* Runs::reference() const {
    return m_reference ? find(*m_reference) : nullptr;
}

std::optional<int> Runs::freeNumber() const {
    for (int number = 0; number < mostRuns; ++number)
        if (!find(number) && std::ranges::find(m_reserved, number) == m_reserved.end()) return number;
    return std::nullopt;
}

QString Runs::pin(ScenarioDocument contents, SolvedBlowPtr blow, const QString& title) {
    for (const Run& run : *m_list)
        if (run.contents.scenario == contents.scenario)
            return tr("This is the run %1 already.").arg(run.title());
    const std::optional<int> number = freeNumber();
    if (!number)
        return tr("There are %1 runs already, the most that can be distinguished: remove one first.")
            .arg(m_list->size());
    const Run* before = reference();
    if (!before && !m_list->empty()) before = &m_list->back();
    const QString change =
        before ? changeWords(before->contents.scenario, contents.scenario, m_units) : QString();
    RunList list = *m_list;
    list.push_back({.number = *number,
                    .name = change.isEmpty() ? title : change,
                    .contents = std::move(contents),
                    .blow = std::move(blow),
                    .isShown = true,
                    .kept = {}});
    if (m_list->empty()) m_reference = number;
    take(std::move(list));
    return {};
}

QStringList Runs::add(const std::vector<KeptRun>& kept) {
    QStringList without;
    RunList list = *m_list;
    const bool wasEmpty = list.empty();
    for (const KeptRun& each : kept) {
        const QString name = QString::fromStdString(each.name);
        const bool isThere = std::ranges::any_of(list, [&](const Run& run) {
            return run.contents.scenario == each.contents.scenario && run.name == name;
        });
        if (isThere) continue;
        const auto isTaken = [&](int number) {
            return std::ranges::find(list, number, &Run::number) != list.end() ||
                   std::ranges::find(m_reserved, number) != m_reserved.end();
        };
        int number = each.number;
        if (isTaken(number))
            for (number = 0; number < mostRuns && isTaken(number);) ++number;
        if (number == mostRuns) {
            without << QString::fromStdString(runLetter(each.number)) + QStringLiteral("  ") + name;
            continue;
        }
        list.push_back({.number = number,
                        .name = name,
                        .contents = each.contents,
                        .blow = nullptr,
                        .isShown = each.isShown,
                        .kept = each.cor,
                        .version = each.version});
        if (wasEmpty && each.isReference) m_reference = number;
    }
    if (list.size() != m_list->size()) take(std::move(list));
    return without;
}

std::vector<KeptRun> Runs::toKeep() const {
    std::vector<KeptRun> kept;
    for (const Run& run : *m_list)
        kept.push_back({.number = run.number,
                        .name = run.name.toStdString(),
                        .contents = run.contents,
                        .isShown = run.isShown,
                        .isReference = m_reference == run.number,
                        .cor = corToKeep(run),
                        .version = versionToKeep(run)});
    return kept;
}

void Runs::remove(int number) {
    RunList list = *m_list;
    if (std::erase_if(list, [=](const Run& run) { return run.number == number; }) == 0) return;
    if (m_reference == number) m_reference = list.empty() ? std::nullopt : std::optional(list.front().number);
    take(std::move(list));
}

void Runs::clear() {
    m_reference.reset();
    m_reserved.clear();
    take({});
}

void Runs::rename(int number, const QString& name) {
    const QString given = name.simplified();
    if (!given.isEmpty()) change(number, [&](Run& run) { run.name = given; });
}

void Runs::setShown(int number, bool shown) {
    change(number, [=](Run& run) { run.isShown = shown; });
}

void Runs::setReference(std::optional<int> number) {
    if (number == m_reference || (number && !find(*number))) return;
    m_reference = number;
    emit changed();
}

void Runs::setBlow(int number, const SolvedBlowPtr& blow) {
    const Run* run = find(number);
    if (run && !run->blow && run->contents.scenario == blow->request.scenario)
        change(number, [&](Run& solved) { solved.blow = blow; });
    if (run) check(*find(number));
}

// A run of a file that comes out otherwise has lost its table.
void Runs::check(const Run& run) {
    constexpr double rounding = 1e-9;  // of another machine
    if (!run.kept || !run.isSolved()) return;
    const double now = run.blow->summary.cor;
    if (std::abs(now - *run.kept) <= run.blow->summary.corError + rounding) return;
    const Message changes = changesSentence(run.version, run.contents.scenario);
    if (!changes.isEmpty()) return emit differs(run.title() + QStringLiteral(": ") + translated(changes));
    const QLocale locale;
    emit differs(tr("%1 had e = %2 and has %3 now: the table of its hammer blow has been changed, or another "
                    "version has solved it.")
                     .arg(run.title(), numberText(*run.kept, 6, locale), numberText(now, 6, locale)));
}

void Runs::change(int number, const std::function<void(Run&)>& change) {
    RunList list = *m_list;
    const auto found = std::ranges::find(list, number, &Run::number);
    if (found == list.end()) return;
    change(*found);
    take(std::move(list));
}

void Runs::take(RunList list) {
    m_list = std::make_shared<const RunList>(std::move(list));
    emit changed();
}

RunSolver::RunSolver(Runs& runs, QObject* parent) : QObject(parent), m_runs(runs) {
    connect(&runs, &Runs::changed, this, &RunSolver::solveNext);
    connect(&m_job, &SolveJob::solved, this, [this](const SolvedBlowPtr& blow) {
        m_runs.setBlow(std::exchange(m_number, -1), blow);
        solveNext();
    });
}

void RunSolver::solveNext() {
    if (m_number >= 0) {
        if (m_runs.find(m_number)) return;  // it is on its way
        m_job.cancel();
        m_number = -1;
    }
    const auto next = std::ranges::find(*m_runs.list(), nullptr, &Run::blow);
    if (next == m_runs.list()->end()) return;
    m_number = next->number;
    const Scenario& scenario = next->contents.scenario;
    m_job.submit({.scenario = scenario, .units = naturalUnits(scenario), .chosenUnits = {}, .pages = {}});
}

RunList runsLike(const Scenario& scenario, const RunList& runs) {
    RunList alike;
    for (const Run& run : runs)
        if (areOfOneKind(run.contents.scenario, scenario)) alike.push_back(run);
    return alike;
}

}  // namespace drillwave
