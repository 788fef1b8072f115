// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/problem_plate.h"

#include <QAbstractScrollArea>
#include <QEvent>
#include <algorithm>

namespace drillwave {
namespace {

constexpr int edge = 4;  // to the sides and from the field [px]

// Returns the viewport that scrolls the field, or the window if there is none.
QWidget* hostOf(QWidget* field) {
    const auto isViewport = [](const QWidget* widget) {
        const auto* area = widget ? qobject_cast<QAbstractScrollArea*>(widget->parentWidget()) : nullptr;
        return area && area->viewport() == widget;
    };
    // A cell of a table is a child of the viewport itself.
    QWidget* host = field->parentWidget();
    while (host->parentWidget() && !host->isWindow() && !isViewport(host) &&
           !isViewport(host->parentWidget()))
        host = host->parentWidget();
    return host;
}

}  // namespace

ProblemPlate::ProblemPlate(QWidget* field) : QLabel(field->parentWidget()), m_field(field) {
    setObjectName(QStringLiteral("problemPlate"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setWordWrap(true);
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    setForegroundRole(QPalette::ToolTipText);
    setMargin(edge);
    field->installEventFilter(this);
    hide();
}

void ProblemPlate::say(const QString& text) {
    setText(text);
    if (QWidget* host = hostOf(m_field); parentWidget() != host) setParent(host);
    place();
    show();
    raise();
}

// Places it below the field; above it if there is no room below.
void ProblemPlate::place() {
    const QWidget* host = parentWidget();
    const int width = std::max(1, host->width() - 2 * edge);
    const int height = heightForWidth(width);
    const int top = m_field->mapTo(host, QPoint(0, 0)).y();
    const int below = top + m_field->height() + edge / 2;
    const bool fits = below + height <= host->height();
    setGeometry(edge, fits ? below : std::max(0, top - height - edge / 2), width, height);
}

bool ProblemPlate::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Hide || event->type() == QEvent::FocusOut)
        hide();
    else if ((event->type() == QEvent::Move || event->type() == QEvent::Resize) && isVisible())
        place();
    return QLabel::eventFilter(watched, event);
}

}  // namespace drillwave
