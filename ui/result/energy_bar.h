// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the hammer's work as one bar.
#pragma once

#include <QWidget>
#include <array>

#include "core/blow/outputs.h"

namespace drillwave {

/// Parts of the hammer work (for a drill string, of the hammer energy) in the order in which the energy bar
/// shows them.
inline constexpr std::array energyParts{EnergyPart::rock, EnergyPart::rebound, EnergyPart::waves,
                                        EnergyPart::hammer, EnergyPart::losses};

/// Returns the short name of a part of the energy, such as "rock".
QString energyPartName(EnergyPart part);
/// Returns the share of a part in the hammer work (for drill strings in the hammer energy), 0 … 1. Negative
/// values from rounding are returned as 0.
double energyShare(const ImpactSummary& summary, EnergyPart part);

/// Horizontal bar of the parts of the energy. They differ in pattern and colour, and have labels where these
/// fit. The bar is empty without a result.
class EnergyBar : public QWidget {
    Q_OBJECT

  public:
    explicit EnergyBar(QWidget* parent = nullptr);

    void present(const ImpactSummary& summary);
    void clear();
    /// Returns the text drawn in this part of the energy bar, such as "rock 62 %"; empty if it does not fit.
    QString labelOf(EnergyPart part) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QRectF partRect(EnergyPart part) const;
    void describe();

    std::array<double, energyParts.size()> m_shares{};  // sum 1; all 0 without a result
};

/// Small sample of the pattern of one part of the energy. It shows in the list below the energy bar which
/// part a row belongs to.
class EnergySwatch : public QWidget {
    Q_OBJECT

  public:
    explicit EnergySwatch(EnergyPart part, QWidget* parent = nullptr);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    EnergyPart m_part;
};

}  // namespace drillwave
