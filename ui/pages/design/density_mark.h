// SPDX-License-Identifier: GPL-3.0-or-later
// A small picture of the distribution of an uncertain input.
#pragma once

#include <QWidget>

#include "core/study/design/distribution.h"

namespace drillwave {

/// Picture of a probability density as a filled area over the range of an uncertain input.
class DensityMark : public QWidget {
    Q_OBJECT

  public:
    explicit DensityMark(QWidget* parent = nullptr);
    void present(const Distribution& distribution);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Distribution m_distribution;
};

}  // namespace drillwave
