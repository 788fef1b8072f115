// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rod/string_rod.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/blow/blow_waves.h"
#include "core/model/drill_string.h"
#include "core/model/scales.h"
#include "core/model/section_pieces.h"
#include "core/model/section_words.h"
#include "core/wave/network/string_waves.h"
#include "core/wave/problem.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

RodForce stressOf(const RodStretch& stretch, const SectionPeak& peak) {
    return {stressOf(stretch, peak.force, peak.place), std::lerp(stretch.rear, stretch.front, peak.place),
            peak.time};
}

void takeLarger(RodForce& largest, const RodForce& force) {
    if (force.size > largest.size) largest = force;
}

}  // namespace

double stressOf(const RodStretch& section, double force, double share) {
    return force * section.toStress / areaAt(section.section, share);
}

double RodStretch::shareAt(double place) const {
    return std::clamp((place - rear) / (front - rear), 0.0, 1.0);
}

std::size_t StringRod::sectionAt(double place) const {
    const auto found = std::ranges::lower_bound(stretches, place, {}, &RodStretch::front);
    return found == stretches.end() ? stretches.size() - 1
                                    : static_cast<std::size_t>(found - stretches.begin());
}

RodForces StringRod::largestAt(double place) const {
    assert(waves);
    RodForces largest;
    for (std::size_t j = sectionAt(place); j < stretches.size() && stretches[j].rear <= place; ++j) {
        const RodStretch& stretch = stretches[j];
        const SectionForces forces = largestForcesAt(*waves, j, stretch.shareAt(place), endOfBlow, forcesEnd);
        for (const Load load : loads) takeLarger(largest[load], stressOf(stretch, forces[load]));
    }
    for (const Load load : loads) largest[load].section = place;
    return largest;
}

StringRod stringRod(const Blow& blow) {
    const DrillString& drill = blow.scenario.drillString;
    const Scales scales = scalesOf(blow.scenario);
    const std::vector<const Section*> sections = allSections(drill);
    const std::vector<Message> words = sectionWords(drill);
    const auto ofHammer = static_cast<int>(drill.hammer.sections.size());
    const std::vector<double> joints = sectionJoints(drill);
    StringRod rod;
    rod.waves = blow.impact.waves;
    rod.endOfBlow = blow.impact.endOfBlow;
    rod.forcesEnd = blow.impact.forcesEnd;
    for (int j = 0; j < static_cast<int>(sections.size()); ++j) {
        const Section& section = *sections[static_cast<std::size_t>(j)];
        RodStretch stretch;
        stretch.rear = joints[static_cast<std::size_t>(j)];
        stretch.front = joints[static_cast<std::size_t>(j) + 1];
        stretch.toStress = scales.force / scales.stress;
        stretch.section = section;
        stretch.number = j < ofHammer ? -(j + 1) : j - ofHammer + 1;
        stretch.name = translated(sectionNameMessage(section.name));
        stretch.words = translated(words[static_cast<std::size_t>(j)]);
        stretch.yieldStrength = section.yieldStrength;
        stretch.fatigueStrength = section.fatigueStrength;
        rod.stretches.push_back(stretch);
    }
    return rod;
}

RodEnvelope stringRodEnvelope(const StringRod& rod, const Blow& blow, const std::stop_token& stop) {
    RodEnvelope envelope;
    if (!rod.waves) return envelope;
    const std::vector<SectionEnvelope> sections = stringEnvelope(blow.impact, stop);
    for (std::size_t j = 0; j < sections.size(); ++j)
        for (const SectionForces& forces : sections[j])
            for (const Load load : loads) {
                if (isAfter(load) && !hasStressesAfter(blow.impact)) continue;
                const RodForce stress = stressOf(rod.stretches[j], forces[load]);
                envelope[load].push_back(stress);
                takeLarger(envelope.largest[load], stress);
            }
    return envelope;
}

}  // namespace drillwave
