// SPDX-License-Identifier: GPL-3.0-or-later
// The context menu of a plot.
#include <QActionGroup>
#include <QContextMenuEvent>
#include <QMenu>

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

}  // namespace

void PlotWidget::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    // The right button opens it on release, when it has not drawn a box.
    if (event->reason() == QContextMenuEvent::Mouse) return;
    openMenu(activeRect() ? activeRect()->center() : rect().center());
}

void PlotWidget::openMenu(QPoint at) {
    makeMenu(at)->popup(mapToGlobal(at));
}

QMenu* PlotWidget::makeMenu(QPoint at) {
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("plotMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    addCopyAndSave(*menu);
    menu->addSeparator();
    addView(*menu, at);
    addCurves(*menu);
    if (!m_cursors.rects().isEmpty()) addCursors(*menu, at);
    return menu;
}

void PlotWidget::addCopyAndSave(QMenu& menu) {
    const bool hasData = m_dataText || !visibleCurves(*this).isEmpty();
    QAction* picture = menu.addAction(tr("Copy &picture"), this, &PlotWidget::copyPicture);
    picture->setToolTip(tr("This view, black on white, for a report"));
    picture->setEnabled(m_current);
    QAction* copy = menu.addAction(tr("Copy &data"), this, &PlotWidget::copyData);
    copy->setToolTip(tr("The numbers of what is shown, as a table for a spreadsheet"));
    copy->setEnabled(hasData && m_current);
    menu.addAction(tr("&Save picture…"), this, &PlotWidget::savePictureRequested)
        ->setToolTip(tr("This view as PNG, SVG or PDF"));
    QAction* save = menu.addAction(tr("Save da&ta…"), this, &PlotWidget::saveDataRequested);
    save->setToolTip(tr("The numbers of what is shown, as CSV"));
    save->setEnabled(hasData);
}

void PlotWidget::addView(QMenu& menu, QPoint at) {
    menu.addAction(withKey(tr("&Fit"), Qt::Key_Home), this, &PlotWidget::fit)
        ->setToolTip(tr("Bring all curves into view"));
    QAction* back = menu.addAction(withKey(tr("&Zoom back"), Qt::Key_Backspace), this, &PlotWidget::zoomBack);
    back->setToolTip(tr("The view before"));
    back->setEnabled(canZoomBack());
    QCPAxisRect* rect = axisRectAt(at) ? axisRectAt(at) : activeRect();
    if (!rect) return;
    addScale(menu, rect->axis(QCPAxis::atBottom), tr("Logarithmic &horizontal axis"));
    addScale(menu, rect->axis(QCPAxis::atLeft), tr("Logarithmic &vertical axis"));
}

void PlotWidget::addScale(QMenu& menu, QCPAxis* axis, const QString& text) {
    const bool logarithmic = axis->scaleType() == QCPAxis::stLogarithmic;
    const QString reason = logarithmic ? QString() : reasonAgainstLogarithm(*axis);
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(logarithmic);
    action->setEnabled(reason.isEmpty());
    action->setToolTip(reason.isEmpty() ? tr("Equal steps are equal factors; zeros are cut off") : reason);
    connect(action, &QAction::toggled, this, [this, axis = QPointer(axis)](bool on) {
        if (axis) setAxisScale(axis, on ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    });
}

void PlotWidget::addCurves(QMenu& menu) {
    const QList<QCPAbstractPlottable*> curves = namedCurves(*this);
    if (curves.isEmpty()) return;
    QMenu* shown = menu.addMenu(tr("&Curves shown"));
    shown->setObjectName(QStringLiteral("curvesMenu"));
    for (QCPAbstractPlottable* curve : curves) {
        QAction* action =
            shown->addAction(QString(curve->name()).replace(QLatin1Char('&'), QLatin1String("&&")));
        action->setCheckable(true);
        action->setChecked(curve->visible());
        connect(action, &QAction::toggled, this, [this, curve = QPointer(curve)](bool on) {
            if (curve) setCurveVisible(curve, on);
        });
    }
}

void PlotWidget::addCursors(QMenu& menu, QPoint at) {
    menu.addSeparator();
    const auto add = [&](PlotCursor cursor, const QString& text, const QKeySequence& key,
                         const QString& toolTip) {
        QAction* action =
            menu.addAction(withKey(text, key), this, [this, cursor, at] { placeCursorByUser(cursor, at); });
        action->setToolTip(toolTip);
    };
    add(PlotCursor::a, tr("Cursor &A here"), Qt::Key_A, tr("Reads the curves here; can be dragged"));
    add(PlotCursor::b, tr("Cursor &B here"), Qt::Key_B,
        tr("Reads the curves here; slope, mean and integral from A to B"));
    if (offersTime())
        add(PlotCursor::time, tr("&Time cursor here"), Qt::Key_T, tr("The instant shown on all pages"));
    QAction* remove = menu.addAction(tr("&Remove cursors A and B"), this, [this] {
        placeCursor(PlotCursor::a, {});
        placeCursor(PlotCursor::b, {});
    });
    remove->setToolTip(tr("And the strip below the plot"));
    remove->setEnabled(cursorPosition(PlotCursor::a) || cursorPosition(PlotCursor::b));
}

}  // namespace drillwave
