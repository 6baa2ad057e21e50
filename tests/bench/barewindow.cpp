// SPDX-License-Identifier: GPL-3.0-or-later
// The reference for the panel's start-up: a bare QMainWindow with one chart, up to its first paint.
#include <QApplication>
#include <QChartView>
#include <QDebug>
#include <QMainWindow>
#include <QTimer>
#include <QWindow>

namespace {

/// Ends the program when the window has been painted, as nmcpanel --quit-after-first-paint does.
class QuitAfterExpose : public QObject {
protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Expose)
            QTimer::singleShot(0, this, [] { QCoreApplication::exit(0); });
        return QObject::eventFilter(watched, event);
    }
};

}  // namespace

int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    QMainWindow window;
    window.setCentralWidget(new QChartView(&window));
    window.resize(1'100, 800);
    window.show();
    QuitAfterExpose quit;
    window.windowHandle()->installEventFilter(&quit);
    const int exitCode = QApplication::exec();
    qDebug() << "painted";
    return exitCode;
}
