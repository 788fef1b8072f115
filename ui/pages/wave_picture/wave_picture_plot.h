// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture of a blow with axes and colour bar: the same drawing code for the page and for files.
#pragma once

#include <optional>

#include "ui/pages/wave_picture/joint_marks.h"
#include "ui/pages/wave_picture/scale_marks.h"
#include "ui/pages/wave_picture/wave_picture_items.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

/// Position in the rod to the right, time upward, force or particle velocity as colour. Fitted, the whole
/// rod, or hammer and string, is in view over all the time of interest.
class WavePicturePlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit WavePicturePlot(QCustomPlot* plot);

    /// Returns the picture needed to show the present view at the present size.
    WavePictureNeed need() const;
    /// Shows a blow that comes with a picture; the view stays where it is unless it was fitted.
    void present(const SolvedBlowPtr& blow);
    /// The blow on show, or nullptr.
    const SolvedBlowPtr& shown() const { return m_blow; }
    /// Its picture, or nullptr.
    const WavePicture* picture() const { return m_blow ? m_blow->page<WavePicture>() : nullptr; }

    void setField(WaveQuantity field);
    WaveQuantity field() const { return m_field; }
    void setFrontsShown(bool shown);
    /// The joints of a string, none of a rod.
    const JointMarksItem& joints() const { return *m_joints; }
    bool frontsShown() const { return m_fronts->visible(); }

    /// The times in view, t/t0.
    TimeSpan timeInView() const { return m_window.time; }
    /// The field over the part in view; see wavePictureCsv(). Empty while nothing is on show.
    QByteArray csv(char separator) const;
    /// Names the axes.
    void name();
    /// The extremes in view and where the colours end, in words; empty while nothing is on show.
    QString rangeText() const;
    /// The place below a point of the plot and the field there, in words; of a string the section and all
    /// that there is. Empty outside of the picture.
    QString readout(const QPointF& pixel) const;

  signals:
    /// The picture on show does not match need() any more.
    void needChanged();
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
    std::optional<WavePictureNeed> m_announced;  // by needChanged(), not answered yet
    bool m_checking = false;
};

}  // namespace drillwave
