// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel's start-up is measured against: a bare QMainWindow with one chart, up to its first paint.
#include <QApplication>
#include <QChartView>
#include <QMainWindow>
#include <QTimer>

namespace {

class BareWindow : public QMainWindow {
protected:
    void paintEvent(QPaintEvent* event) override {
        QMainWindow::paintEvent(event);
        QTimer::singleShot(0, this, [] { QCoreApplication::exit(0); });
    }
};

}  // namespace

int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    BareWindow window;
    window.setCentralWidget(new QChartView(&window));
    window.resize(1'100, 800);
    window.show();
    return QApplication::exec();
}
