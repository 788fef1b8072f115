// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rod/string_rod.h"

#include <QCoreApplication>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/blow/blow_waves.h"
#include "core/model/drill_string.h"
#include "core/model/scales.h"
#include "core/model/section_size.h"
#include "core/wave/network/string_envelope.h"
#include "core/wave/network/string_problem.h"

namespace drillwave {
namespace {

RodForce stressOf(const RodStretch& stretch, const SectionPeak& peak) {
    return {peak.force * stretch.toStress, std::lerp(stretch.rear, stretch.front, peak.place), peak.time};
}

void takeLarger(RodForce& largest, const RodForce& force) {
    if (force.size > largest.size) largest = force;
}

}  // namespace

QString sectionName(const RodStretch& section) {
    const QString number = section.number < 0
                               ? QCoreApplication::translate("drillwave::StringRod", "hammer section %1")
                               : QCoreApplication::translate("drillwave::StringRod", "section %1");
    const QString text = number.arg(std::abs(section.number));
    return section.name.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(section.name, text);
}

double stressOf(const RodStretch& section, double force) {
    return force / networkForce * section.toStress;
}

std::size_t StringRod::sectionAt(double place) const {
    const auto found = std::ranges::lower_bound(stretches, place, {}, &RodStretch::front);
    return found == stretches.end() ? stretches.size() - 1
                                    : static_cast<std::size_t>(found - stretches.begin());
}

RodForces StringRod::largestAt(double place) const {
    assert(waves);
    RodForces largest;
    largest.compression.section = largest.tension.section = place;
    for (std::size_t j = sectionAt(place); j < stretches.size() && stretches[j].rear <= place; ++j) {
        const RodStretch& stretch = stretches[j];
        const double xi = std::clamp((place - stretch.rear) / (stretch.front - stretch.rear), 0.0, 1.0);
        const SectionForces forces = largestForcesAt(*waves, j, xi);
        takeLarger(largest.compression, stressOf(stretch, forces.compression));
        takeLarger(largest.tension, stressOf(stretch, forces.tension));
    }
    largest.compression.section = largest.tension.section = place;
    return largest;
}

StringRod stringRod(const Blow& blow) {
    const DrillString& drill = blow.scenario.drillString;
    const Scales scales = scalesOf(blow.scenario);
    const std::vector<const Section*> sections = allSections(drill);
    const auto ofHammer = static_cast<int>(drill.hammer.sections.size());
    const std::vector<double> joints = sectionJoints(drill);
    StringRod rod;
    rod.waves = blow.string->impact.waves;
    for (int j = 0; j < static_cast<int>(sections.size()); ++j) {
        const Section& section = *sections[static_cast<std::size_t>(j)];
        RodStretch stretch;
        stretch.rear = joints[static_cast<std::size_t>(j)];
        stretch.front = joints[static_cast<std::size_t>(j) + 1];
        stretch.toStress =
            networkForce * scales.force / propertiesOf(section, drill.material).area / scales.stress;
        stretch.diameter = outerDiameter(section);
        stretch.number = j < ofHammer ? -(j + 1) : j - ofHammer + 1;
        stretch.name = QString::fromStdString(section.name);
        stretch.yieldStrength = section.yieldStrength;
        stretch.fatigueStrength = section.fatigueStrength;
        rod.stretches.push_back(stretch);
    }
    return rod;
}

RodEnvelope stringRodEnvelope(const StringRod& rod, const Blow& blow, const std::stop_token& stop) {
    RodEnvelope envelope;
    if (!rod.waves) return envelope;
    const std::vector<SectionEnvelope> sections = stringEnvelope(blow.string->impact, stop);
    for (std::size_t j = 0; j < sections.size(); ++j)
        for (const SectionForces& forces : sections[j]) {
            envelope.compression.push_back(stressOf(rod.stretches[j], forces.compression));
            envelope.tension.push_back(stressOf(rod.stretches[j], forces.tension));
            takeLarger(envelope.largest.compression, envelope.compression.back());
            takeLarger(envelope.largest.tension, envelope.tension.back());
        }
    return envelope;
}

}  // namespace drillwave
