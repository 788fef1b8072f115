// SPDX-License-Identifier: GPL-3.0-or-later
// Distribution of an uncertain number, as a small picture.
#pragma once

#include <QWidget>

#include "core/study/design/distribution.h"

namespace drillwave {

/// The density over the range, linear to the right, as an area.
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
