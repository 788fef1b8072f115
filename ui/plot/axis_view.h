// SPDX-License-Identifier: GPL-3.0-or-later
// View of an axis: ranges that stay usable, and its scale, linear or logarithmic.
#pragma once

#include <qcustomplot.h>

#include <QString>

namespace drillwave {

/// Returns `wanted` if an axis of this scale can show it with ticks that differ in double precision, else
/// `present`. A usable range is finite, with magnitudes up to 1e100 and a width of at least 1e-12 of its
/// larger magnitude. On a logarithmic scale it is also positive and spans less than 300 decades.
QCPRange usableRange(QCPRange wanted, QCPRange present, QCPAxis::ScaleType scale);

/// Changes the range of the axis by `factor` (less than 1 zooms in). The value at `aroundPixel` stays where
/// it is.
void zoomAxis(QCPAxis& axis, double factor, double aroundPixel);

/// Pans the axis during a drag from `fromPixel` to `toPixel`. `start` is the range before the drag. The value
/// that was at `fromPixel` is then at `toPixel`.
void panAxis(QCPAxis& axis, QCPRange start, double fromPixel, double toPixel);

/// Zooms the axis to the range between two of its pixels, given in either order.
void zoomAxisTo(QCPAxis& axis, double pixel, double otherPixel);

/// Returns why the axis cannot be logarithmic with its visible curves; empty if it can. Values of zero do not
/// prevent this, because impact forces begin with zeros. The axis cuts them off at its edge.
QString reasonAgainstLogarithm(const QCPAxis& axis);

/// Makes the axis, and the opposite axis of its rect, linear or logarithmic, with suitable ticks. A change to
/// logarithmic also fits the range to the positive values of the visible curves.
void setScale(QCPAxis& axis, QCPAxis::ScaleType scale);

/// Sets the range of a logarithmic axis to the positive values of its visible curves, but at most 9 decades
/// below their largest value. A linear axis is left unchanged.
void fitLogarithmic(QCPAxis& axis);

/// Sets the number of ticks that an axis aims at according to its length: from 3 to 5 on a vertical axis,
/// from 2 to 5 on a horizontal one. Returns true if the number has changed; the plot must then be redrawn.
bool setTickCount(QCPAxis& axis);

/// Returns the label of an axis so that it is not longer than a vertical axis and stays within the edges of
/// the plot. A label of one line that is too long gets two lines if both fit. Otherwise the words before its
/// unit or value are cut with an ellipsis, or left out if only a letter would remain.
QString labelThatFits(const QCPAxis& axis);

/// Returns the room that is reserved for a second line of the label [px]; 0 if there is none.
int secondLine(const QCPAxis& axis);
/// Adds the room of a second line to the distance between label and ticks (QCPAxis::labelPadding()), or
/// removes it. The label still has one line; labelThatFits() is set only while the plot is drawn. Returns
/// true if the room has changed; the plot must then be redrawn.
bool reserveSecondLine(QCPAxis& axis, bool isWanted);

/// Sets the number of significant digits of the tick labels, from 6 to 16, so that neighbouring labels
/// differ. Labels that are powers of ten are left as they are.
void setTickDigits(QCPAxis& axis);

}  // namespace drillwave
