// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the hammer's work, as one bar.
#pragma once

#include <QWidget>
#include <array>

#include "core/blow/outputs.h"

namespace drillwave {

/// The parts in the order of the bar.
inline constexpr std::array energyParts{EnergyPart::rock, EnergyPart::rebound, EnergyPart::waves,
                                        EnergyPart::hammer, EnergyPart::losses};

/// A short word for a share: "rock".
QString energyPartName(EnergyPart part);
/// The share of the whole, 0 … 1; what rounding makes negative is 0.
double energyShare(const ImpactSummary& summary, EnergyPart part);

/// A horizontal bar whose parts differ in pattern, colour and, where they fit, words. Empty without a
/// result.
class EnergyBar : public QWidget {
    Q_OBJECT

  public:
    explicit EnergyBar(QWidget* parent = nullptr);

    void present(const ImpactSummary& summary);
    void clear();
    /// The words in a part; empty where they do not fit.
    QString labelOf(EnergyPart part) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QRectF partRect(EnergyPart part) const;
    void describe();

    std::array<double, energyParts.size()> m_shares{};  // together 1, or all 0 without a result
};

/// The pattern of one part, for the list at the bar.
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
