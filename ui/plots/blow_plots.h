// The four plots of a blow on one time axis: the same drawing code for the page and for files.
#pragma once

#include <QObject>
#include <QString>
#include <array>

#include "ui/plots/blow_curves.h"
#include "ui/plots/plot_style.h"

namespace drillwave {

/// Lays four axis rects with linked time axes into a plot and fills them. Lives as a child of the plot.
class BlowPlots : public QObject {
    Q_OBJECT

  public:
    static constexpr int plotCount = 4;

    explicit BlowPlots(QCustomPlot* plot);

    /// Shows the curves; the view stays where it is unless it was fitted or the units changed.
    void show(const BlowCurves& curves);
    /// No curves, and `message` in their place (why there are none).
    void showNothing(const QString& message);
    void setStyle(const PlotStyle& style);
    /// All curves in view.
    void fit();
    /// What the plots show, in words, for assistive tools.
    QString textSummary() const { return m_summary; }
    QCPAxisRect* axisRect(int index) const { return m_plots.at(static_cast<std::size_t>(index)).rect; }

  private:
    struct Plot {
        QCPAxisRect* rect = nullptr;
        QCPTextElement* title = nullptr;
        QCPLegend* legend = nullptr;
        QVector<QCPGraph*> graphs;
    };
    void addPlot(std::size_t index, const QStringList& names, QCPMarginGroup* margins);
    void linkTimeAxes();
    void setLabels(const BlowCurves& curves);
    void summarize(const BlowCurves& curves);

    QCustomPlot* m_plot;
    std::array<Plot, plotCount> m_plots;
    QCPItemText* m_message;
    ShownUnits m_units;
    double m_timeEnd = 1;
    bool m_fitted = true;  // until the user zooms or pans
    bool m_fitting = false;
    QString m_summary;
};

}  // namespace drillwave
