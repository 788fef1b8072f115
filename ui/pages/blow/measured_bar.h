// SPDX-License-Identifier: GPL-3.0-or-later
// A row of controls for the measured signals over a blow: choice of the signal, shift in time, removal.
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

/// Controls for the measured signals over the curves of a blow. The row is hidden while there are no signals.
class MeasuredBar : public QWidget {
    Q_OBJECT

  public:
    /// Creates the controls. List and units must outlive them.
    MeasuredBar(MeasuredList& list, const UnitChoice& units, QWidget* parent = nullptr);

    /// Takes the colours of the measured curves from the style of the plots, for the icons in the list.
    void setStyle(const PlotStyle& style);
    /// Sets whether measured and computed curves can be compared, which needs a scenario in physical units.
    /// If not, the row says that the signals are not drawn.
    void setComparable(bool comparable);
    /// Shows `text`, which states how far the chosen measured signal deviates from the computed curve; hidden
    /// if `text` is empty.
    void setMisfit(const QString& text);
    /// Returns the index (from 0) of the chosen signal in the list; 0 if the list is empty.
    std::size_t chosen() const;

  signals:
    /// Reports that the user wants to see the section where a signal was measured. x is its position from the
    /// struck end [m].
    void placeChosen(double x);
    /// Reports that the user wants to shift the signal with this index in time to its best fit with the
    /// computed curve.
    void alignmentWanted(std::size_t index);
    /// Reports that another signal was chosen.
    void chosenChanged();

  private:
    void showList();
    void showChosen();
    int indexOfNew() const;

    MeasuredList& m_list;
    const UnitChoice& m_units;
    std::vector<std::string> m_names;  // names of the signals in the list shown
    int m_gesture = 1;                 // number of the present edit: its shifts form one undo step
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
