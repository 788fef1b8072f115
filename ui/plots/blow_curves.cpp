#include "ui/plots/blow_curves.h"

#include <QVector>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/wave/wave_field.h"

namespace drillwave {
namespace {

// One "inf" in the data would make every rescaling of the axes fail without a word.
void append(QVector<QCPGraphData>& points, double time, double value) {
    if (std::isfinite(time) && std::isfinite(value)) points.append(QCPGraphData(time, value));
}

GraphData graphData(const QVector<QCPGraphData>& points) {
    auto data = GraphData::create();
    data->set(points, true);
    return data;
}

GraphData scaled(const std::vector<double>& time, const std::vector<double>& value, const ShownUnit& timeUnit,
                 const ShownUnit& valueUnit, bool startsAtRest) {
    QVector<QCPGraphData> points;
    points.reserve(static_cast<qsizetype>(time.size()) + 2);
    if (startsAtRest && !time.empty() && time.front() > 0) {
        append(points, 0, 0);
        append(points, time.front() * timeUnit.factor, 0);
    }
    for (std::size_t i = 0; i < time.size(); ++i)
        append(points, time[i] * timeUnit.factor, value[i] * valueUnit.factor);
    return graphData(points);
}

// Times at which the impulse of the hammer is sampled: its curve is smooth inside a segment.
std::vector<double> pulseTimes(const PulseForce& pulse) {
    constexpr int samplesPerSegment = 48;
    std::vector<double> times{0};
    for (const PulseSegment& segment : pulse.segments) {
        const bool straight = segment.kind == PulseSegment::Kind::linear && segment.slope == 0;
        const int samples = straight ? 1 : samplesPerSegment;
        for (int i = 1; i <= samples; ++i) times.push_back(segment.start + segment.length * i / samples);
    }
    return times;
}

GraphData momentumData(const Impact& impact, const PulseForce& pulse, const std::vector<double>& history,
                       const ShownUnits& units) {
    std::vector<double> times = pulseTimes(pulse);
    times.insert(times.end(), history.begin(), history.end());
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    QVector<QCPGraphData> points;
    points.reserve(static_cast<qsizetype>(times.size()));
    for (double t : times) {
        const double given = pulse.isRigidBody() ? 1 : pulse.impulseUntil(t);
        append(points, t * units.time.factor, momentum(impact, given, t) * units.impulse.factor);
    }
    return graphData(points);
}

double lastTime(const GraphData& data) {
    return data->isEmpty() ? 0 : (data->constEnd() - 1)->key;
}

}  // namespace

BlowCurves blowCurves(const Impact& impact, const PulseForce& pulse, const ShownUnits& units,
                      double section) {
    BlowCurves curves;
    curves.units = units;
    curves.section = section;
    const std::vector<SectionWave> waves = sectionWaves(impact, section, BlowCurves::waveCount);
    for (std::size_t i = 0; i < curves.waves.size(); ++i)
        curves.waves[i] = i < waves.size()
                              ? scaled(waves[i].time, waves[i].value, units.time, units.force, false)
                              : GraphData::create();
    const SampledHistory history = sampleHistory(impact);
    curves.force = scaled(history.time, history.force, units.time, units.force, true);
    curves.impulse = scaled(history.time, history.impulse, units.time, units.impulse, true);
    curves.momentum = momentumData(impact, pulse, history.time, units);
    for (const GraphData& data :
         {curves.waves[0], curves.waves[1], curves.waves[2], curves.waves[3], curves.force, curves.momentum})
        curves.timeEnd = std::max(curves.timeEnd, lastTime(data));
    return curves;
}

}  // namespace drillwave
