// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_menu.h"

#include "ui/plot/axis_view.h"
#include "ui/plot/legend_entries.h"
#include "ui/plot/plot_widget.h"

namespace drillwave {
namespace {

// The key is told in the menu and handled by the plot while it has the focus: as a shortcut of the action it
// would be dead, the menu being there only while it is open.
QString withKey(const QString& text, const QKeySequence& key) {
    return text + QLatin1Char('\t') + key.toString(QKeySequence::NativeText);
}

// Fills one menu for one plot.
class PlotActions {
  public:
    PlotActions(QMenu& menu, PlotWidget& plot, QPoint at) : m_menu(menu), m_plot(plot), m_at(at) {
        addCopyAndSave();
        m_menu.addSeparator();
        addView();
        addCurves();
        if (m_plot.keyPoint().isOffered()) addKeyPoint();
        if (!m_plot.reader().cursors().rects().isEmpty()) addCursors();
    }

  private:
    void addCopyAndSave();
    void addView();
    void addScale(QCPAxis* axis, const QString& text);
    void addCurves();
    void addCursors();
    void addKeyPoint();

    QMenu& m_menu;
    PlotWidget& m_plot;
    QPoint m_at;
};

void PlotActions::addCopyAndSave() {
    QAction* picture = m_menu.addAction(PlotMenu::tr("Copy &picture"), &m_plot, &PlotWidget::copyPicture);
    picture->setToolTip(PlotMenu::tr("The present view, black on white, for a report"));
    picture->setEnabled(m_plot.isCurrent());
    QAction* copy = m_menu.addAction(PlotMenu::tr("Copy &data"), &m_plot, &PlotWidget::copyData);
    copy->setToolTip(PlotMenu::tr("The numbers of what is shown, as a table for a spreadsheet"));
    copy->setEnabled(m_plot.hasData() && m_plot.isCurrent());
    m_menu.addAction(PlotMenu::tr("&Save picture…"), &m_plot, &PlotWidget::savePictureRequested)
        ->setToolTip(PlotMenu::tr("This view as PNG, SVG or PDF"));
    QAction* save = m_menu.addAction(PlotMenu::tr("Save da&ta…"), &m_plot, &PlotWidget::saveDataRequested);
    save->setToolTip(PlotMenu::tr("The numbers of what is shown, as CSV"));
    save->setEnabled(m_plot.hasData());
}

void PlotActions::addView() {
    m_menu.addAction(withKey(PlotMenu::tr("&Fit"), Qt::Key_Home), &m_plot, &PlotWidget::fit)
        ->setToolTip(PlotMenu::tr("Bring all curves into view"));
    QAction* back = m_menu.addAction(withKey(PlotMenu::tr("&Zoom back"), Qt::Key_Backspace), &m_plot,
                                     [plot = &m_plot] { plot->view().goBack(); });
    back->setToolTip(PlotMenu::tr("The previous view"));
    back->setEnabled(m_plot.view().canGoBack());
    QCPAxisRect* rect = m_plot.axisRectAt(m_at) ? m_plot.axisRectAt(m_at) : m_plot.view().activeRect();
    if (!rect) return;
    addScale(rect->axis(QCPAxis::atBottom), PlotMenu::tr("Logarithmic &horizontal axis"));
    addScale(rect->axis(QCPAxis::atLeft), PlotMenu::tr("Logarithmic &vertical axis"));
}

void PlotActions::addScale(QCPAxis* axis, const QString& text) {
    const bool logarithmic = axis->scaleType() == QCPAxis::stLogarithmic;
    const QString reason = logarithmic ? QString() : reasonAgainstLogarithm(*axis);
    QAction* action = m_menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(logarithmic);
    action->setEnabled(reason.isEmpty());
    action->setToolTip(reason.isEmpty()
                           ? PlotMenu::tr("Equal steps are equal ratios; values of zero are not shown")
                           : reason);
    QObject::connect(action, &QAction::toggled, &m_plot, [plot = &m_plot, axis = QPointer(axis)](bool on) {
        if (axis) plot->setAxisScale(axis, on ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    });
}

void PlotActions::addCurves() {
    const QList<QCPAbstractPlottable*> curves = namedCurves(m_plot);
    if (curves.isEmpty()) return;
    QMenu* shown = m_menu.addMenu(PlotMenu::tr("&Curves shown"));
    shown->setObjectName(QStringLiteral("curvesMenu"));
    for (QCPAbstractPlottable* curve : curves) {
        QAction* action =
            shown->addAction(QString(curve->name()).replace(QLatin1Char('&'), QLatin1String("&&")));
        action->setCheckable(true);
        action->setChecked(curve->visible());
        QObject::connect(action, &QAction::toggled, &m_plot,
                         [plot = &m_plot, curve = QPointer(curve)](bool on) {
                             if (curve) plot->setCurveVisible(curve, on);
                         });
    }
}

void PlotActions::addKeyPoint() {
    QAction* enter =
        m_menu.addAction(withKey(PlotMenu::tr("&Point for keys"), Qt::Key_Enter), &m_plot, [plot = &m_plot] {
            plot->setFocus();
            plot->keyPoint().enter();
        });
    enter->setToolTip(
        PlotMenu::tr("Arrows move the point, N goes to the next mark, Enter acts like a click"));
    enter->setEnabled(!m_plot.keyPoint().place());
}

void PlotActions::addCursors() {
    m_menu.addSeparator();
    const auto add = [this](PlotCursor cursor, const QString& text, const QKeySequence& key,
                            const QString& toolTip) {
        m_menu
            .addAction(withKey(text, key), &m_plot,
                       [plot = &m_plot, cursor, at = m_at] { plot->mover().placeAt(cursor, at); })
            ->setToolTip(toolTip);
    };
    add(PlotCursor::a, PlotMenu::tr("Cursor &A here"), Qt::Key_A,
        PlotMenu::tr("Reads the curves here; drag it to move it"));
    add(PlotCursor::b, PlotMenu::tr("Cursor &B here"), Qt::Key_B,
        PlotMenu::tr("Reads the curves here; slope, mean and integral from A to B"));
    if (m_plot.offersTime())
        add(PlotCursor::time, PlotMenu::tr("&Time cursor here"), Qt::Key_T,
            PlotMenu::tr("The time shown on all pages"));
    CurveReader& reader = m_plot.reader();
    QAction* remove = m_menu.addAction(PlotMenu::tr("&Remove cursors A and B"), &reader, &CurveReader::clear);
    remove->setToolTip(PlotMenu::tr("The table below the plot then reads the values in view"));
    remove->setEnabled(reader.position(PlotCursor::a) || reader.position(PlotCursor::b));
    QAction* copy = m_menu.addAction(PlotMenu::tr("Copy the &table below"), &reader, &CurveReader::copy);
    copy->setToolTip(
        PlotMenu::tr("The readings at the cursors, or the numbers in view, to paste into a spreadsheet"));
    copy->setEnabled(!reader.text().isEmpty() && m_plot.isCurrent());
}

}  // namespace

PlotMenu::PlotMenu(PlotWidget& plot, QPoint at) : QMenu(&plot) {
    setObjectName(QStringLiteral("plotMenu"));
    setAttribute(Qt::WA_DeleteOnClose);
    fillPlotMenu(*this, plot, at);
}

void fillPlotMenu(QMenu& menu, PlotWidget& plot, QPoint at) {
    menu.setToolTipsVisible(true);
    menu.clear();
    qDeleteAll(menu.findChildren<QMenu*>(Qt::FindDirectChildrenOnly));
    PlotActions(menu, plot, at);
}

}  // namespace drillwave
