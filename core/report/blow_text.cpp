// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_text.h"

#include <cmath>
#include <optional>

#include "core/blow/outputs.h"
#include "core/report/alert_words.h"
#include "core/report/feed_words.h"
#include "core/report/report_numbers.h"
#include "core/report/report_text.h"
#include "core/report/string_text.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

/// One line of results: what is multiplied with the scale is also given in SI.
class ResultRows {
  public:
    explicit ResultRows(const Scenario& scenario) : m_dimensional(hasUnits(scenario)) {}

    void add(const char* label, double value, const char* unit, double scale, Quantity quantity) {
        const std::string shown = rounded(value) + " " + unit;
        if (m_dimensional)
            m_grid.add({label, shown, inHandyUnit(value * scale, quantity)});
        else
            m_grid.add({label, shown});
    }
    /// The same with where and when.
    void add(const char* label, const RodForce& force, const Blow& blow) {
        std::vector<std::string> cells{label, rounded(force.size) + " F0/A"};
        if (m_dimensional) cells.push_back(inHandyUnit(force.size * blow.scales.stress, Quantity::stress));
        if (force.size > 0) cells.push_back(placeText(force, blow));
        m_grid.add(std::move(cells));
    }
    void addText(const char* label, std::string text) { m_grid.add({label, std::move(text)}); }
    std::string text() const { return m_grid.text(); }

  private:
    bool m_dimensional;
    TextGrid m_grid{CellAlignment::left};
};

/// Shares of the energy are known to 1e-12: what is smaller is rounding.
double share(double fraction) {
    return std::abs(fraction) < 1e-12 ? 0 : fraction;
}

void addStresses(ResultRows& rows, const Blow& blow) {
    if (!blow.summary.rodForces) return;
    const RodForces& forces = *blow.summary.rodForces;
    rows.add("largest compression", forces.compression, blow);
    rows.add("largest tension", forces.tension, blow);
    rows.add("  compression after", forces.compressionAfter, blow);
    rows.add("  tension after", forces.tensionAfter, blow);
}

/// What there is where blows have a frequency.
void addRate(ResultRows& rows, const Blow& blow) {
    const auto add = [&](const char* label, const char* name, const char* bound) {
        const Output& output = *findOutput(name);
        if (!output.problem(blow.scenario).empty()) return;
        if (const auto value = output.value({blow.summary, blow.scenario}))
            rows.addText(label, bound + inHandyUnit(*value, output.quantity(), 4));
    };
    add("percussion power", "percussion_power", "");
    add("penetration rate", "penetration_rate", "at most ");
}

/// Of the margin over the largest of the four needs.
std::string marginText(double margin, double effective) {
    const double need = effective / (1 + margin);
    const std::string share = rounded(100 * std::abs(margin), 3) + " %";
    return inHandyUnit(need, Quantity::force, 4) +
           (margin < 0 ? ", not met: short by " + inHandyUnit(need - effective, Quantity::force, 4) + " (" +
                             share + ")"
                       : ", met with " + inHandyUnit(effective - need, Quantity::force, 4) + " (" + share +
                             ") to spare");
}

void addFeed(ResultRows& rows, const Blow& blow) {
    if (!blow.feed) return;
    const std::optional<FeedForce>& force = blow.feed->force;
    std::string needed = inHandyUnit(blow.feed->fullRate, Quantity::force);
    if (force) needed += ", installed " + inHandyUnit(force->thrust, Quantity::force);
    if (force && force->weight) needed += ", effective " + inHandyUnit(force->effective(), Quantity::force);
    rows.addText("thrust needed", needed);
    if (const std::optional<double> margin = blow.thrustMargin())
        rows.addText("  at every gap", marginText(*margin, force->effective()));
    if (force) rows.addText("  feed", std::string(feedWord(blow.feed->feed)));
}

std::string resultText(const Blow& blow) {
    const ImpactSummary& summary = blow.summary;
    const Scales& scales = blow.scales;
    const double work = summary.workRatio * scales.energy;
    ResultRows rows(blow.scenario);
    rows.addText("restitution e",
                 rounded(summary.cor, 12) +
                     (blow.method.method == Method::lattice ? "  (error estimated as " : "  (error below ") +
                     boundText(summary.corError) + ")");
    rows.add("impulse 1 + e", summary.impulse, "I0", scales.impulse, Quantity::impulse);
    rows.add("peak force", summary.peakForce, "F0", scales.force, Quantity::force);
    rows.add("largest penetration", summary.maxPenetration, "d0", scales.penetration, Quantity::length);
    rows.add("residual penetration", summary.residualPenetration, "d0", scales.penetration, Quantity::length);
    addStresses(rows, blow);
    addRate(rows, blow);
    rows.add("first contact", summary.firstContactTime, "t0", scales.time, Quantity::time);
    rows.add("last separation", summary.separationTime, "t0", scales.time, Quantity::time);
    rows.add("time in contact", summary.contactDuration, "t0", scales.time, Quantity::time);
    rows.add("hammer work W", summary.workRatio, "W0", scales.energy, Quantity::energy);
    rows.add("  in the rock", share(summary.energy.rockWork), "W", work, Quantity::energy);
    rows.add("  in the rebound", share(summary.energy.reboundEnergy), "W", work, Quantity::energy);
    rows.add("  in waves", share(summary.energy.residualWaveEnergy), "W", work, Quantity::energy);
    rows.addText("balance errors", rounded(summary.momentumResidual, 2) + " of I0, " +
                                       rounded(summary.energy.residual, 2) + " of W");
    addFeed(rows, blow);
    return rows.text();
}

std::string methodText(const MethodChoice& choice) {
    std::string text(name(choice.method));
    if (choice.method != Method::lattice) return text;
    return text + " of " + std::to_string(choice.lattice.segments) + " segments";
}

}  // namespace

std::string blowText(const Blow& blow) {
    const Impact& impact = blow.impact;
    std::string text = titleLine(blow.scenario) + paragraph(feedDecisionText(blow.decision())) +
                       groupsLine(blow.scenario) + "\n";
    text += blow.isOfString() ? stringResultText(blow) : resultText(blow);
    text += "\n  method " + (blow.isOfString() ? "polynomial cells" : methodText(blow.method)) + ", " +
            std::to_string(impact.contacts) + (impact.contacts == 1 ? " contact, " : " contacts, ") +
            std::to_string(impact.pieces) +
            (blow.isOfString()                       ? " cells"
             : blow.method.method == Method::lattice ? " steps"
                                                     : " pieces") +
            ", solved in " + inHandyUnit(blow.runTime, Quantity::time) + "\n";
    for (const Alert& alert : blow.alerts) {
        // The line of e says it already, as an estimate.
        if (blow.method.method == Method::lattice && alert.code == AlertCode::reducedAccuracy) continue;
        text += std::string("  ") + (alert.level == AlertLevel::warning ? "warning: " : "note: ") +
                alertText(alert) + "\n";
    }
    return text;
}

}  // namespace drillwave
