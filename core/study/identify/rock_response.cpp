// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/rock_response.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

/// Corners within one step beyond which the step is left as it is: only noise of the last bit makes more.
constexpr int mostLineChanges = 12;

}  // namespace

std::vector<TrialLine> powerLines(double stiffness, double exponent, double reference) {
    std::vector<TrialLine> lines;
    const double u1 = reference / stiffness;
    double before = 0, force = 0;
    for (int i = -16; i <= 12; ++i) {  // nodes U1 2^(i/4), i even: 0.4 % of the force, far below a misfit
        const double u = u1 * std::exp2(i / 4.0);
        const double next = reference * std::pow(u / u1, exponent);
        lines.push_back({force, (next - force) / (u - before)});
        before = u;
        force = next;
    }
    return lines;
}

RockResponse::RockResponse(const TrialRock& rock, const End& end, double step)
    : m_rock(rock),
      m_impedance(end.barBehind ? end.impedance / 2 : end.impedance),
      m_double(end.barBehind ? 1 : 2),
      m_mass(end.mass),
      m_dashpot(rock.dashpot),
      m_step(step),
      m_contact(rock.gap) {}

double RockResponse::largestPenetration() const {
    const TrialLine& line = m_rock.lines[m_loading];
    return m_loadedPenetration + (m_largest - line.force) / line.slope;
}

double RockResponse::penetration() const {
    if (m_line == Line::apart) return m_place - m_rock.gap;
    return largestPenetration() - (m_largest - m_spring) / m_rock.elastic;
}

double RockResponse::springAfter(const Wave& wave, double rate, double time) const {
    const double part = -std::expm1(-rate * time);
    return m_spring + part * (wave.g - m_spring) + wave.rate * (time - part / rate);
}

/// The time in [0, end] at which the spring force passes `force`, once it does.
double RockResponse::timeTo(const Wave& wave, double rate, double end, double force) const {
    double low = 0, high = end;
    double atLow = m_spring - force, atHigh = springAfter(wave, rate, end) - force;
    if (atLow == 0 || atLow * atHigh > 0) return 0;
    for (int i = 0; i < 40 && high - low > 1e-9 * end; ++i) {
        double middle = low + (high - low) * atLow / (atLow - atHigh);
        if (i % 3 == 2) middle = (low + high) / 2;
        const double at = springAfter(wave, rate, middle) - force;
        if (at == 0) return middle;
        if (at * atLow > 0)
            low = middle, atLow = at;
        else
            high = middle, atHigh = at;
    }
    return low - atLow * (high - low) / (atHigh - atLow);
}

void RockResponse::touch() {
    m_spring = 0;
    m_line = m_largest == 0 ? Line::primary : Line::elastic;
}

void RockResponse::separate() {
    m_spring = 0;
    m_contact = m_rock.gap + largestPenetration() - m_largest / m_rock.elastic;
    m_place = m_contact;
    m_line = Line::apart;
}

void RockResponse::load(const Wave& wave, double& left) {
    const double rate = rateOf(m_rock.lines[m_loading].slope);
    const double excess = wave.g - m_spring;
    if (excess < 0 || (excess == 0 && wave.rate < 0)) {
        m_line = Line::elastic;
        return;
    }
    double time = left;
    double spring = springAfter(wave, rate, left);
    bool turns = false;
    if (wave.g + wave.rate * left < spring && wave.rate < 0) {
        time = std::min(left, std::log1p(-excess * rate / wave.rate) / rate);  // U' = 0
        spring = springAfter(wave, rate, time);
        turns = true;
    }
    const bool hasCorner = m_loading + 1 < m_rock.lines.size();
    if (hasCorner && spring > m_rock.lines[m_loading + 1].force) {
        const TrialLine& line = m_rock.lines[m_loading];
        const double corner = m_rock.lines[m_loading + 1].force;
        time = timeTo(wave, rate, time, corner);
        m_loadedPenetration += (corner - line.force) / line.slope;
        ++m_loading;
        spring = corner;
        turns = false;
    }
    m_spring = m_largest = std::max(spring, m_largest);
    if (turns) m_line = Line::elastic;
    left -= time;
}

void RockResponse::unload(const Wave& wave, double& left) {
    const double rate = rateOf(m_rock.elastic);
    const double spring = springAfter(wave, rate, left);
    if (spring > m_largest) {
        left -= timeTo(wave, rate, left, m_largest);
        m_spring = m_largest;
        m_line = Line::primary;
    } else if (spring < 0) {
        left -= timeTo(wave, rate, left, 0);
        separate();
    } else {
        m_spring = spring;
        left = 0;
    }
}

void RockResponse::fly(const Wave& wave, double& left) {
    const double way = (m_contact - m_place) * m_impedance;
    const double gone = (wave.g + wave.rate * left / 2) * left;
    if (gone <= way) {
        m_place += gone / m_impedance;
        left = 0;
        return;
    }
    // wave.g t + rate t²/2 = way, the first root
    const double root = std::sqrt(std::max(0.0, wave.g * wave.g + 2 * wave.rate * way));
    const double time = wave.g + root > 0 ? 2 * way / (wave.g + root) : left;
    left -= std::clamp(time, 0.0, left);
    touch();
}

bool RockResponse::follow(Wave& wave, double& left) {
    const double before = left;
    switch (m_line) {
        case Line::apart:
            fly(wave, left);
            break;
        case Line::primary:
            load(wave, left);
            break;
        case Line::elastic:
            unload(wave, left);
            break;
    }
    wave.g += wave.rate * (before - left);
    return left > 0;
}

void RockResponse::advance(double g0, double g1) {
    if (m_mass > 0) {
        advanceMass(g0, g1);
        return;
    }
    Wave wave{m_double * g0, m_double * (g1 - g0) / m_step};
    double left = m_step;
    for (int i = 0; i < mostLineChanges && follow(wave, left); ++i) {
    }
    m_force = m_spring;
    if (m_dashpot > 0 && m_line != Line::apart)
        m_force =
            std::max(0.0, m_spring + m_dashpot * (m_double * g1 - m_spring) / (m_impedance + m_dashpot));
}

void RockResponse::advanceMass(double g0, double g1) {
    const double impedance = m_impedance + m_dashpot;
    double left = m_step, g = m_double * g0;
    const double change = m_double * (g1 - g0) / m_step;
    for (int i = 0; i < mostLineChanges && left > 0; ++i) {
        const double slope = m_line == Line::apart     ? 0
                             : m_line == Line::primary ? m_rock.lines[m_loading].slope
                                                       : m_rock.elastic;
        const auto velocityAfter = [&](double time) {
            const double c = impedance * time / (2 * m_mass), k = slope * time * time / (4 * m_mass);
            const double push = time / (2 * m_mass) * (2 * g + change * time - 2 * m_spring);
            return (m_velocity * (1 - c - k) + push) / (1 + c + k);
        };
        double velocity = velocityAfter(left), time = left;
        double moved = (m_velocity + velocity) / 2 * left;
        Line next = m_line;
        const double spring = m_spring + slope * moved;
        // The share of the step up to where the line ends, the way being almost straight within it.
        const auto cut = [&](double share, Line line) {
            time = left * std::clamp(share, 0.0, 1.0);
            next = line;
        };
        bool corner = false;
        if (m_line == Line::apart && m_place + moved > m_contact)
            cut((m_contact - m_place) / moved, m_largest == 0 ? Line::primary : Line::elastic);
        else if (m_line == Line::primary && velocity < 0)
            cut(m_velocity > 0 ? m_velocity / (m_velocity - velocity) : 0, Line::elastic);
        else if (m_line == Line::primary && m_loading + 1 < m_rock.lines.size() &&
                 spring > m_rock.lines[m_loading + 1].force) {
            cut((m_rock.lines[m_loading + 1].force - m_spring) / (spring - m_spring), Line::primary);
            corner = true;
        } else if (m_line == Line::elastic && spring > m_largest)
            cut((m_largest - m_spring) / (spring - m_spring), Line::primary);
        else if (m_line == Line::elastic && spring < 0)
            cut(m_spring / (m_spring - spring), Line::apart);
        if (time < left) {
            velocity = velocityAfter(time);
            moved = (m_velocity + velocity) / 2 * time;
        }
        if (m_line == Line::apart)
            m_place += moved;
        else
            m_spring = std::max(0.0, m_spring + slope * moved);
        m_velocity = velocity;
        if (m_line == Line::primary) m_largest = std::max(m_largest, m_spring);
        if (corner) {
            const TrialLine& line = m_rock.lines[m_loading];
            m_loadedPenetration += (m_rock.lines[m_loading + 1].force - line.force) / line.slope;
            ++m_loading;
            m_spring = m_largest = m_rock.lines[m_loading].force;
        }
        if (m_line == Line::apart && next != m_line) touch();
        if (m_line != Line::apart && next == Line::apart) separate();
        m_line = next;
        g += change * time;
        left -= time;
    }
    m_force = m_line == Line::apart ? 0 : std::max(0.0, m_spring + m_dashpot * m_velocity);
}

}  // namespace drillwave
