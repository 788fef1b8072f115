// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/blow_waves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/blow/string_curves.h"
#include "core/contact/contact_law.h"
#include "core/wave/field/wave_field.h"
#include "core/wave/problem.h"

namespace drillwave {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<double> sectionJoints(const DrillString& drillString) {
    double hammer = 0, string = 0;
    for (const Section& section : drillString.hammer.sections) hammer += section.length;
    const std::vector<const Section*> sections = expandedSections(drillString);
    for (const Section* section : sections) string += section->length;
    std::vector<double> joints;
    double place = -hammer;
    for (const Section& section : drillString.hammer.sections) {
        joints.push_back(place / string);
        place += section.length;
    }
    place = 0;
    for (const Section* section : sections) {
        joints.push_back(place / string);
        place += section->length;
    }
    joints.push_back(1);
    return joints;
}

BlowWaves::BlowWaves(const Blow& blow) : m_blow(&blow) {
    assert(blow.impact.hasHistories());
    if (blow.impact.waves) m_string.emplace(*blow.impact.waves, sectionJoints(blow.scenario.drillString));
}

double BlowWaves::end() const {
    return m_string ? m_string->end() : std::numeric_limits<double>::infinity();
}

WaveRaster BlowWaves::raster(WaveQuantity quantity, const RasterGrid& grid) const {
    return m_string ? m_string->raster(quantity, grid) : waveRaster(m_blow->impact, quantity, grid);
}

double BlowWaves::value(WaveQuantity quantity, double x, double t) const {
    return m_string ? m_string->value(quantity, x, t) : waveValue(m_blow->impact, quantity, x, t);
}

RodState BlowWaves::state(double x, double t) const {
    if (!m_string) return rodState(m_blow->impact, m_blow->problem.force(), std::max(0.0, x), t);
    return StringHistory(m_blow->impact, m_blow->problem, stringPlace(m_blow->scenario.drillString, x)).at(t);
}

std::vector<RodState> BlowWaves::sampled(const StringPlace& place) const {
    return m_string ? StringHistory(m_blow->impact, m_blow->problem, place).sampled()
                    : sampledStates(m_blow->impact, m_blow->problem);
}

TimeSpan BlowWaves::interesting() const {
    if (!m_string) return interestingTime(m_blow->impact, m_blow->problem.force());
    const std::vector<ContactInterval> touching = contacts();
    TimeSpan contact =
        touching.empty() ? TimeSpan{unknown, unknown} : TimeSpan{touching.front().begin, touching.back().end};
    if (m_blow->marched && !touching.empty()) {  // behind the blow it bounces or rests until the next one
        contact.begin = 0;
        if (std::isfinite(m_blow->summary.separationTime)) contact.end = m_blow->summary.separationTime;
    }
    TimeSpan span = interestingTime(contact, arrival(), roundTrip());
    span.end = std::min(span.end, end());
    return span.begin < span.end ? span : TimeSpan{0, end()};
}

double BlowWaves::arrival() const {
    return m_string ? m_string->arrival() : WaveField(m_blow->impact).arrival();
}

double BlowWaves::roundTrip() const {
    return m_string ? 2 * m_string->arrival() : WaveField(m_blow->impact).roundTrip();
}

std::vector<double> BlowWaves::fronts() const {
    const Problem& problem = m_blow->problem;
    if (problem.isForced()) return pulseFronts(problem.force());
    return {0, m_string->hammerRoundTrip()};
}

std::vector<FrontRun> BlowWaves::frontRuns(double start, double begin, double end) const {
    return m_string ? m_string->frontRuns(start, begin, std::min(end, m_string->end()))
                    : drillwave::frontRuns(m_blow->impact, start, begin, end);
}

std::vector<ContactInterval> BlowWaves::contacts() const {
    std::vector<ContactInterval> contacts = contactIntervals(m_blow->impact);
    // Of a string that was not followed to the separation that time is of an earlier contact, or none.
    const bool isOpen = !contacts.empty() && !(contacts.back().end >= contacts.back().begin);
    if (m_string && isOpen) contacts.back().end = end();
    return contacts;
}

std::vector<ContactInterval> BlowWaves::faceContacts() const {
    if (!m_string) return {};
    const PiecewisePolynomial& force = m_blow->impact.waves->faceForce();
    std::vector<ContactInterval> contacts;
    for (const PiecewisePolynomial::Piece& piece : force.pieces()) {
        if (piece.count == 0) continue;
        const double begin = piece.start, until = piece.start + piece.length;
        if (!contacts.empty() && begin <= contacts.back().end + m_blow->impact.waves->rounding())
            contacts.back().end = until;
        else
            contacts.push_back({begin, until});
    }
    return contacts;
}

BitState BlowWaves::bit(const std::vector<ContactInterval>& contacts, double t) const {
    if (!m_string) return bitState(m_blow->impact, contacts, m_blow->problem.gap, t);
    const StringWaves& waves = *m_blow->impact.waves;
    const auto displacement = [&](double time) {
        return waves.bitVelocity().integral(std::clamp(time, 0.0, waves.end())) * lawUnitOfPenetration;
    };
    return bitState(displacement, contacts, m_blow->problem.gap, t);
}

double BlowWaves::impactForce(double t) const {
    if (!m_string) return WaveField(m_blow->impact).impactForce(t);
    return std::max(0.0, m_blow->impact.waves->bitForce()(t));
}

}  // namespace drillwave
