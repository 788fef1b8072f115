// SPDX-License-Identifier: GPL-3.0-or-later
// The measured signals laid over a blow, in a row: which there are, their shift in time, and away with them.
#pragma once

#include <QWidget>

#include "ui/document/measured_list.h"
#include "ui/plot/plot_style.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace drillwave {

class ChoiceBox;
class QuantityField;
class UnitChoice;

/// Hidden while there is none.
class MeasuredBar : public QWidget {
    Q_OBJECT

  public:
    /// List and units must outlive it.
    MeasuredBar(MeasuredList& list, const UnitChoice& units, QWidget* parent = nullptr);

    /// Names and colours as in the plots; `comparable` is whether they can be drawn there.
    void setStyle(const PlotStyle& style);
    void setComparable(bool comparable);
    /// Sets the deviation of the chosen signal from the computed curve; empty if it is not known.
    void setMisfit(const QString& text);
    std::size_t chosen() const;

  signals:
    /// The user wants to see the section where a signal was measured, x [m].
    void placeChosen(double x);
    /// The user wants to shift the signal with that index so that it fits the computed curve.
    void alignmentWanted(std::size_t index);
    /// Another one is chosen.
    void chosenChanged();

  private:
    void showList();
    void showChosen();
    int indexOfNew() const;

    MeasuredList& m_list;
    const UnitChoice& m_units;
    std::vector<std::string> m_names;  // in the list on show
    int m_gesture = 1;                 // of the shifts that are one step
    PlotStyle m_style;
    ChoiceBox* m_box;
    QPushButton* m_place;
    QuantityField* m_shift;
    QPushButton* m_align;
    QToolButton* m_remove;
    QLabel* m_misfit;
    QLabel* m_remark;
};

}  // namespace drillwave
