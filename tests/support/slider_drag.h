// SPDX-License-Identifier: GPL-3.0-or-later
// A slider as a hand drags it.
#pragma once

#include <QEventLoop>
#include <QSlider>
#include <QTimer>
#include <optional>

#include "tests/support/gap_watch.h"
#include "tests/support/window_parts.h"
#include "ui/form/scenario_panel.h"

namespace drillwave::test {

/// Drags the stiffness of a window through `steps` places, one each time the event loop has turned ten times,
/// and returns how long the loop let wait meanwhile; nothing if the drag did not end.
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
        // Ten turns after the last of the steps: what it brings counts as well.
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
