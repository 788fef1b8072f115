// SPDX-License-Identifier: GPL-3.0-or-later
// Simulation of a user dragging a slider.
#pragma once

#include <QEventLoop>
#include <QSlider>
#include <QTimer>
#include <optional>

#include "tests/support/gap_watch.h"
#include "tests/support/window_parts.h"
#include "ui/form/scenario_panel.h"

namespace drillwave::test {

/// Drags the stiffness slider of a window through `steps` positions, one for every ten turns of the event
/// loop. Returns how long the loop was blocked; nothing if the drag took over a minute.
inline std::optional<GapWatch> dragStiffness(const MainWindow& window, int steps) {
    auto* slider =
        part<ScenarioPanel>(window).findChild<QSlider*>(QStringLiteral("bit_rock.stiffness.slider"));
    constexpr int turnsPerStep = 10, first = 300, stride = 5;
    GapWatch gaps;
    QEventLoop loop;
    QTimer timer;
    int turns = 0;
    QObject::connect(&timer, &QTimer::timeout, slider, [&] {
        gaps.turn();
        if (++turns % turnsPerStep == 0) slider->setValue(first + stride * turns / turnsPerStep);
        // Ten more turns after the last step, so that its effects are measured as well.
        if (turns > turnsPerStep * (steps + 1)) loop.quit();
    });
    QTimer::singleShot(60000, &loop, [&loop] { loop.exit(1); });
    slider->setSliderDown(true);
    timer.start(1);
    const bool isWhole = loop.exec() == 0;
    slider->setSliderDown(false);
    if (!isWhole) return std::nullopt;
    return gaps;
}

}  // namespace drillwave::test
