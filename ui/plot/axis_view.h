// SPDX-License-Identifier: GPL-3.0-or-later
// View of an axis: ranges that stay usable, and its scale, linear or logarithmic.
#pragma once

#include <qcustomplot.h>

#include <QString>

namespace drillwave {

/// `wanted` if an axis of this scale can show it with ticks that differ in double precision: finite,
/// magnitudes up to 1e100, no narrower than 1e-12 of its place, on a logarithmic scale positive and not
/// wider than 300 decades; else `present`.
QCPRange usableRange(QCPRange wanted, QCPRange present, QCPAxis::ScaleType scale);

/// Changes the range by `factor` (less than 1 zooms in) around a pixel of the axis.
void zoomAxis(QCPAxis& axis, double factor, double aroundPixel);

/// Moves what was at `fromPixel` when the range was `start` to `toPixel`.
void panAxis(QCPAxis& axis, QCPRange start, double fromPixel, double toPixel);

/// Shows what is between two pixels of the axis.
void zoomAxisTo(QCPAxis& axis, double pixel, double otherPixel);

/// Returns why the axis cannot be logarithmic with its visible curves; empty when it can. Zeros are cut off
/// at the edge: an impact force begins with them.
QString reasonAgainstLogarithm(const QCPAxis& axis);

/// Linear or logarithmic, with the ticks that go with it, also on the opposite side of the rect; switching to
/// logarithmic shows the positive values of the visible curves.
void setScale(QCPAxis& axis, QCPAxis::ScaleType scale);

/// Sets a logarithmic axis to the positive values of the visible curves, at most 9 decades of them.
void fitLogarithmic(QCPAxis& axis);

/// Sets as many ticks on a vertical axis as its height has room for numbers, at most five or so. Returns
/// whether the number has changed.
bool setTickCount(QCPAxis& axis);

/// Gives the ticks enough digits to differ, six at least; ticks that are powers of ten stay so.
void setTickDigits(QCPAxis& axis);

}  // namespace drillwave
