// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture of the waves of a blow with axes and colour bar; the same code draws the page and files.
#pragma once

#include <optional>

#include "ui/pages/wave_picture/joint_marks.h"
#include "ui/pages/wave_picture/scale_marks.h"
#include "ui/pages/wave_picture/wave_picture_items.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Plot with position to the right, time upwards, and force or particle velocity as colour. Fitting shows the
/// whole rod, or hammer and string, from the start of the blow to shortly after the last contact of the bit.
class WavePicturePlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit WavePicturePlot(QCustomPlot* plot);

    /// Returns the picture needed to show the present view at the present size.
    WavePictureNeed need() const;
    /// Shows a blow, which must have a wave picture. The present zoom is kept, unless the view was fitted.
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
    /// Returns the field over the part in view as a table; see wavePictureCsv(). Empty if nothing is shown.
    QByteArray csv(char separator) const;
    /// Names the axes in the present language.
    void name();
    /// Returns a text with the extremes in view and the end of the colour scale; empty if nothing is shown.
    QString rangeText() const;
    /// Returns a text that explains the lines of the wave fronts; empty if they are not shown.
    QString frontsText() const;
    /// Returns a text with position, time and field at a point of the plot; for a drill string with section,
    /// force, stress and velocity. Empty outside the picture.
    QString readout(const QPointF& pixel) const;

  signals:
    /// Reports that the picture shown no longer has the part and the resolution that need() returns.
    void needChanged();
    /// Reports that the part in view has changed.
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
