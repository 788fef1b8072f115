// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/gap_study.h"

#include <algorithm>
#include <stdexcept>

#include "core/blow/impact_summary.h"
#include "core/model/parameter.h"
#include "core/wave/exact/exact_solver.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/translation.h"

namespace drillwave {
namespace {

constexpr double mostMean = 1e6;  // d0, as the command

// A first look at a curve that takes seconds: gaps halved again and again, shown now and then.
class Preview {
  public:
    Preview(const GapQuestion& question, const StudyFeed<GapAnswer>& feed)
        : m_question(question), m_feed(feed), m_problem(problemOf(question.scenario)) {}

    void run() {
        const double start = gapPeriodStart(m_problem);
        if (!std::isfinite(start)) return;
        take(start);
        take(start + 1);
        constexpr int mostParts = 32;
        for (int parts = 2; parts <= mostParts; parts *= 2) {
            for (int i = 1; i < parts; i += 2) take(start + double(i) / parts);
            if (m_feed.stop.stop_requested()) return;
            if (parts < 4) continue;
            if (m_pieces < worthIt) return;  // the whole curve is there in a moment
            m_feed.show({.report = GapStudy{.scenario = m_question.scenario,
                                            .curve = {},
                                            .normal = m_question.normal,
                                            .statistics = {},
                                            .runTime = 0},
                         .samples = m_samples});
        }
    }

  private:
    static constexpr long worthIt = 100'000;  // wave pieces of five blows: the whole curve takes seconds

    void take(double gap) {
        if (m_feed.stop.stop_requested()) return;
        m_problem.gap = gap;
        const Impact impact = m_solver.solve(m_problem, Detail::events, m_feed.stop);
        m_pieces += impact.pieces;
        if (!impact.isSolved()) return;
        const ImpactSummary summary = summarize(impact, m_problem);
        const GapSample sample{gap, {summary.cor, summary.peakForce, summary.energy.rockWork}};
        m_samples.insert(std::ranges::upper_bound(m_samples, gap, {}, &GapSample::gap), sample);
    }

    const GapQuestion& m_question;
    const StudyFeed<GapAnswer>& m_feed;
    Problem m_problem;
    ExactSolver m_solver;
    std::vector<GapSample> m_samples;
    long m_pieces = 0;
};

}  // namespace

bool GapQuestion::operator==(const GapQuestion& other) const {
    const auto same = [](const NormalGap& a, const NormalGap& b) {
        return a.mean == b.mean && a.deviation == b.deviation;
    };
    return scenario == other.scenario && normal.has_value() == other.normal.has_value() &&
           (!normal || same(*normal, *other.normal));
}

QString scatterProblem(const NormalGap& normal) {
    const QLocale locale;
    if (!(normal.mean >= 0 && normal.mean <= mostMean))
        return tr("The mean gap must be from 0 to %1 d₀.").arg(numberText(mostMean, 3, locale));
    if (!(normal.deviation >= NormalGap::leastDeviation && normal.deviation <= NormalGap::mostDeviation))
        return tr("The deviation of the gap must be from %1 to %2 d₀.")
            .arg(numberText(NormalGap::leastDeviation, 3, locale),
                 numberText(NormalGap::mostDeviation, 3, locale));
    return {};
}

GapQuestion gapQuestion(Scenario scenario, const std::optional<NormalGap>& normal) {
    findParameter("delta")->assign(scenario, 0);
    scenario.title.clear();  // says that an example was changed, be it the gap
    return {std::move(scenario), normal};
}

GapAnswer answerGap(const GapQuestion& question, const StudyFeed<GapAnswer>& feed) {
    constexpr std::size_t parts = 1000;  // of the work
    if (question.normal)
        if (const QString problem = scatterProblem(*question.normal); !problem.isEmpty())
            throw std::runtime_error(problem.toStdString());
    Preview(question, feed).run();
    const auto progress = [&](double done) {
        feed.tell({.done = static_cast<std::size_t>(done * parts), .wanted = parts});
    };
    GapAnswer found{.report = studyGap(question.scenario, question.normal, feed.stop, progress),
                    .samples = {}};
    if (!feed.stop.stop_requested() && !found.isComplete())
        throw std::runtime_error(
            tr("Not solved at all gaps: %1").arg(translated(found.report.curve.reason)).toStdString());
    return found;
}

}  // namespace drillwave
