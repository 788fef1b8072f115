// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture of the waves of a blow with axes and colour bar; the same code draws the page and files.
#pragma once

#include <optional>

#include "ui/pages/wave_picture/joint_marks.h"
#include "ui/pages/wave_picture/scale_marks.h"
#include "ui/pages/wave_picture/wave_picture_items.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Plot with position to the right, time upwards, and force or particle velocity as colour. Zoom to fit shows
/// all positions, from the start of the blow to shortly after the last contact of the bit.
class WavePicturePlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit WavePicturePlot(QCustomPlot* plot);

    /// Returns the field, part and resolution that a wave picture must have to fill the present view.
    WavePictureNeed need() const;
    /// Shows a blow, which must have a wave picture. A zoom by the user is kept.
    void present(const SolvedBlowPtr& blow);
    /// Returns the blow that is shown; nullptr if there is none.
    const SolvedBlowPtr& shown() const { return m_blow; }
    /// Returns the wave picture of the blow that is shown; nullptr if there is none.
    const WavePicture* picture() const { return m_blow ? m_blow->page<WavePicture>() : nullptr; }

    void setField(WaveQuantity field);
    WaveQuantity field() const { return m_field; }
    void setFrontsShown(bool shown);
    /// Returns the plot item that draws the joints and names of the sections of a drill string; it draws
    /// nothing for a uniform rod.
    const JointMarksItem& joints() const { return *m_joints; }
    bool frontsShown() const { return m_fronts->visible(); }

    /// Returns the time span in view [t0].
    TimeSpan timeInView() const { return m_window.time; }
    /// Returns the field (force or particle velocity) over the part in view as a table; see wavePictureCsv().
    /// Empty if nothing is shown.
    QByteArray csv(char separator) const;
    /// Sets the labels of the axes in the present language.
    void name();
    /// Returns a text with the smallest and largest value in view. If these exceed the colour scale, it also
    /// states where the scale ends. Empty if nothing is shown.
    QString rangeText() const;
    /// Returns a text that explains the lines of the wave fronts; empty if they are not shown.
    QString frontsText() const;
    /// Returns a text with position, time and field (force or particle velocity) at a point of the plot. For
    /// a drill string it has section, force, stress and velocity. Empty outside the picture.
    QString readout(const QPointF& pixel) const;

  signals:
    /// Reports that a new wave picture must be computed: the one shown no longer has the field, part or
    /// resolution that need() returns.
    void needChanged();
    /// Reports that the range of positions or times in view has changed.
    void viewChanged();

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void addItems();
    QList<WavePictureItem*> items() const { return {m_waves, m_fronts, m_joints, m_contacts, m_marks}; }
    void followAxes();
    void takeRanges();
    void showWindow();
    void checkNeed();
    void summarize();
    QString stringReadout(double x, double t) const;

    QCPColorScale* m_bar;
    WaveFieldItem* m_waves;
    JointMarksItem* m_joints;
    WaveFrontsItem* m_fronts;
    ContactBarsItem* m_contacts;
    ScaleMarksItem* m_marks;
    SolvedBlowPtr m_blow;
    WaveQuantity m_field = WaveQuantity::force;
    PictureWindow m_window;
    std::optional<WavePictureNeed> m_announced;  // need of the last needChanged() that is not yet answered
    bool m_checking = false;
};

}  // namespace drillwave
