// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/wave_picture_csv.h"

#include <QStringList>
#include <algorithm>
#include <string>

#include "core/text/csv.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

constexpr int places = 101;
constexpr int times = 201;

// The ends themselves, whatever rounding makes of what is between.
double between(double begin, double end, int index, int count) {
    return index == count - 1 ? end : begin + (end - begin) * index / (count - 1);
}

std::string header(const QStringList& names, char separator) {
    std::string text;
    for (const QString& name : names) {
        if (!text.empty()) text += separator;
        text += separator == ',' ? csvCell(name.toStdString()) : name.simplified().toStdString();
    }
    return text + '\n';
}

}  // namespace

QByteArray wavePictureCsv(const SolvedBlow& blow, WaveQuantity field, const PictureWindow& window,
                          const QStringList& names, char separator) {
    const PictureUnits& units = blow.page<WavePicture>()->units;
    const BlowWaves waves(blow);
    const double left = std::clamp(window.xiBegin, waves.rear(), 1.0);
    const double right = std::clamp(window.xiEnd, left, 1.0);
    const double last = std::min(window.time.end, waves.end());
    std::string text = header(names, separator);
    for (int row = 0; row < times; ++row) {
        const double t = between(std::min(window.time.begin, last), last, row, times);
        for (int column = 0; column < places; ++column) {
            const double xi = between(left, right, column, places);
            text += formatNumber(xi * units.position.factor) + separator;
            text += formatNumber(t * units.time.factor) + separator;
            text += formatNumber(waves.value(field, xi, t) * units.of(field).factor) + '\n';
        }
    }
    return QByteArray::fromStdString(text);
}

}  // namespace drillwave
