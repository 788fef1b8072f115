// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/blow_waves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/contact/contact_law.h"
#include "core/model/scales.h"
#include "core/model/section_pieces.h"
#include "core/wave/field/wave_field.h"
#include "core/wave/problem.h"

namespace drillwave {

namespace {

/// Smallest change that counts as a jump or bend, in forces [F0] and velocities [v0].
constexpr double negligible = 1e-4;

/// Returns the largest difference of two instants in the quantities that may jump.
double distance(const RodState& a, const RodState& b) {
    return std::max({std::abs(a.impactForce - b.impactForce), std::abs(a.faceForce - b.faceForce),
                     std::abs(a.positiveWave - b.positiveWave), std::abs(a.negativeWave - b.negativeWave),
                     std::abs(a.frontVelocity - b.frontVelocity)});
}

RodState middleOf(const RodState& a, const RodState& b) {
    RodState middle;
    middle.impactForce = (a.impactForce + b.impactForce) / 2;
    middle.faceForce = (a.faceForce + b.faceForce) / 2;
    middle.positiveWave = (a.positiveWave + b.positiveWave) / 2;
    middle.negativeWave = (a.negativeWave + b.negativeWave) / 2;
    middle.frontVelocity = (a.frontVelocity + b.frontVelocity) / 2;
    return middle;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double hammerRear(const DrillString& drillString) {
    if (drillString.hammer.sections.empty()) return 0;
    return 0 - hammerProperties(drillString).length / stringProperties(drillString).length;
}

SignalBar barAt(const Scenario& scenario, double share) {
    const auto bar = [](double area, double modulus, double density) -> SignalBar {
        return {area, modulus, area * std::sqrt(modulus * density)};
    };
    const DrillString& drillString = scenario.drillString;
    const std::vector<const Section*> sections = allSections(drillString);
    const Rod& rod = scenario.rod;
    if (sections.empty()) return bar(propertiesOf(rod).area, rod.youngsModulus, rod.density);
    const StringPlace at = stringPlace(drillString, share);
    const Section& section = *sections[at.section];
    return bar(areaAt(section, at.share), section.youngsModulus.value_or(drillString.material.youngsModulus),
               section.density.value_or(drillString.material.density));
}

StringPlace stringPlace(const DrillString& drillString, double share) {
    const std::vector<const Section*> sections = allSections(drillString);
    if (sections.empty()) return {0, std::clamp(share, 0.0, 1.0)};
    const std::size_t ofHammer = drillString.hammer.sections.size();
    // Where hammer and string meet, the string.
    const bool inHammer = share < 0;
    const std::size_t first = inHammer ? 0 : ofHammer, last = (inHammer ? ofHammer : sections.size()) - 1;
    double left = std::min(share, 1.0) * stringProperties(drillString).length;
    if (inHammer) left = std::max(0.0, left + hammerProperties(drillString).length);
    std::size_t i = first;
    for (; i < last && left > sections[i]->length; ++i) left -= sections[i]->length;
    return {i, std::clamp(left / sections[i]->length, 0.0, 1.0)};
}

double shareOfString(const DrillString& drillString, const StringPlace& place) {
    const std::vector<const Section*> sections = allSections(drillString);
    if (sections.empty()) return place.share;
    assert(place.section < sections.size());
    double from = -hammerProperties(drillString).length;
    for (std::size_t i = 0; i < place.section; ++i) from += sections[i]->length;
    if (place.section == drillString.hammer.sections.size()) from = 0;  // whatever the sum is rounded to
    return (from + place.share * sections[place.section]->length) / stringProperties(drillString).length;
}

StringPlace middleOfLongest(const DrillString& drillString) {
    const std::vector<const Section*> sections = expandedSections(drillString);
    const auto longest =
        std::ranges::max_element(sections, {}, [](const Section* section) { return section->length; });
    return {drillString.hammer.sections.size() + static_cast<std::size_t>(longest - sections.begin()), 0.5};
}

StringHistory::StringHistory(const Impact& impact, const Problem& problem, const StringPlace& place)
    : m_impact(&impact), m_problem(&problem), m_waves(impact.waves.get()), m_place(place) {
    assert(m_waves && place.section < m_waves->sections());
}

RodState StringHistory::at(double time, TimeSide side) const {
    const StringWaves& waves = *m_waves;
    const double t = std::clamp(time, 0.0, waves.end());
    const double beside = side == TimeSide::after ? t + waves.rounding() : t - waves.rounding();
    const std::size_t ofHammer = waves.hammerSections();
    const double momentum = m_impact->hammerImpulse, v0 = m_problem->velocity();
    RodState now;
    now.time = t;
    now.impactForce = std::max(0.0, waves.bitForce()(beside));
    now.impulse = waves.bitForce().integral(t) / momentum;
    now.momentum = waves.given(t) / momentum - now.impulse;
    now.penetration = waves.bitVelocity().integral(t) * lawUnitOfPenetration - m_problem->gap;
    now.frontVelocity = waves.bitVelocity()(beside) / v0;
    const double pushed = ofHammer > 0 ? waves.force(ofHammer - 1, 1, t, side) : waves.force(0, 0, t, side);
    now.faceForce = std::max(0.0, ofHammer > 0 ? pushed : pushed - waves.damperForce()(beside));
    const double down = waves.down(m_place.section, m_place.share, t, side);
    const double up = waves.up(m_place.section, m_place.share, t, side);
    now.positiveWave = 0 - down;
    now.negativeWave = 0 - up;
    now.normalForce = 0 - (down + up);
    now.velocity = waves.velocity(m_place.section, m_place.share, t, side) / v0;
    return now;
}

std::vector<double> StringHistory::pieceTimes() const {
    std::vector<double> times = m_waves->pieceTimes(m_place.section, m_place.share);
    for (const PiecewisePolynomial* curve : {&m_waves->faceForce(), &m_waves->bitForce()})
        for (const PiecewisePolynomial::Piece& piece : curve->pieces())
            if (piece.start > 0 && piece.start < m_waves->end()) times.push_back(piece.start);
    std::sort(times.begin(), times.end());
    const double same = m_waves->rounding();
    times.erase(std::unique(times.begin(), times.end(), [same](double a, double b) { return b - a <= same; }),
                times.end());
    return times;
}

std::vector<RodState> StringHistory::sampled() const {
    const std::vector<double> times = pieceTimes();
    std::vector<RodState> rows;
    rows.reserve(times.size() + times.size() / 4);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const RodState now = at(times[i]);
        if (i > 0) {
            const RodState before = at(times[i], TimeSide::before);
            const RodState start = rows.back();
            const RodState middle = at((times[i - 1] + times[i]) / 2);
            const double bend = distance(middle, middleOf(start, before));
            const int chords = std::clamp(static_cast<int>(std::sqrt(bend / negligible)) + 1, 1, 32);
            for (int k = 1; k < chords; ++k)
                rows.push_back(at(times[i - 1] + (times[i] - times[i - 1]) * k / chords));
            if (i + 1 == times.size() || distance(before, now) > negligible) rows.push_back(before);
        }
        if (i + 1 < times.size()) rows.push_back(now);
    }
    return rows;
}

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
    // For a string not followed to that separation, the time is that of an earlier contact, or none.
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
