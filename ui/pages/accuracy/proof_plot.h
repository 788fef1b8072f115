// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs as points on two logarithmic axes: error against run time, extreme cases against their marks.
#pragma once

#include <optional>

#include "ui/pages/accuracy/proof_picture.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Draws a picture of proofs: fitted, all points are in view.
class ProofPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit ProofPlot(QCustomPlot* plot);

    /// Shows the picture; the view stays where it is unless it was fitted or the axes are others.
    void present(const ProofPicture& picture);
    /// The row of the study whose point is nearest to a pixel, if one is near.
    std::optional<int> rowAt(QPointF pixel) const;
    /// Sets the function that names a row of the study, for users who go there by keys.
    void setNames(std::function<QString(int)> nameOf) { m_nameOf = std::move(nameOf); }
    /// The keys go from point to point.
    KeyPlaces keyPlaces() const override;

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void clearPoints();
    void addSeries(const ProofSeries& series, int index);
    void placeLabels();
    void setNumbersVisible(bool visible);

    QVector<QCPGraph*> m_graphs;  // of the series
    QVector<QCPItemText*> m_labels;
    QCPItemStraightLine* m_mark;
    QCPItemText* m_markName;
    ProofPicture m_picture;
    std::function<QString(int)> m_nameOf;
};

}  // namespace drillwave
