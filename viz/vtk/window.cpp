// The window of glisson view: time slider, list of fields, keys.
#include <vtkCallbackCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "picture.hpp"

namespace glisson::viz {
namespace {

class Window {
 public:
  explicit Window(Scene& scene) : scene_(scene) {
    window_->SetSize(scene.request().width, scene.request().height);
    window_->SetWindowName(("Glisson: " + scene.request().results).c_str());
    window_->AddRenderer(scene.renderer());
    interactor_->SetRenderWindow(window_);
    interactor_->SetInteractorStyle(style_);
    const auto& fields = scene.fields();
    const std::string wanted = scene.request().field.substr(0, scene.request().field.find(':'));
    const auto found = std::find(fields.begin(), fields.end(), wanted);
    if (found != fields.end()) field_ = static_cast<int>(found - fields.begin());
  }

  void run() {
    interactor_->Initialize();
    add_slider();
    listen(interactor_, vtkCommand::KeyPressEvent, [](Window& w) { w.on_key(); });
    listen(interactor_, vtkCommand::LeftButtonPressEvent, [](Window& w) { w.on_click(); });
    if (scene_.request().seconds > 0) {
      listen(interactor_, vtkCommand::TimerEvent, [](Window& w) { w.interactor_->TerminateApp(); });
      interactor_->CreateOneShotTimer(static_cast<unsigned long>(1000 * scene_.request().seconds));
    }
    draw();
    interactor_->Start();
    end();
  }

 private:
  using Action = void (*)(Window&);

  /// The scene's renderer outlives the window, so what it holds on the graphics card goes while that is
  /// there.
  void end() {
    if (slider_->GetInteractor() != nullptr) slider_->EnabledOff(), slider_->SetInteractor(nullptr);
    scene_.renderer()->RemoveAllViewProps();
    window_->RemoveRenderer(scene_.renderer());
    window_->Finalize();
  }

  void listen(vtkObject* object, unsigned long event, Action action) {
    actions_.emplace_back(this, action);
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
      const auto* entry = static_cast<std::pair<Window*, Action>*>(data);
      entry->second(*entry->first);
    });
    command->SetClientData(&actions_.back());
    object->AddObserver(event, command, 1.0);
  }

  void add_slider() {
    const int last = static_cast<int>(scene_.steps().size()) - 1;
    if (last == 0) return;
    bar_->SetMinimumValue(0), bar_->SetMaximumValue(last), bar_->SetValue(scene_.step());
    bar_->SetLabelFormat("step %0.0f");
    bar_->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    bar_->GetPoint1Coordinate()->SetValue(0.3, 0.06);
    bar_->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    bar_->GetPoint2Coordinate()->SetValue(0.7, 0.06);
    bar_->GetLabelProperty()->SetColor(0.13, 0.15, 0.18);
    bar_->GetLabelProperty()->ShadowOff();
    slider_->SetInteractor(interactor_);
    slider_->SetRepresentation(bar_);
    slider_->SetAnimationModeToJump();
    slider_->EnabledOn();
    listen(slider_, vtkCommand::InteractionEvent,
           [](Window& w) { w.go_to(std::lround(w.bar_->GetValue())); });
  }

  void go_to(long step) {
    const long last = static_cast<long>(scene_.steps().size()) - 1;
    const int wanted = static_cast<int>(std::clamp(step, 0L, last));
    if (wanted == scene_.step()) return;
    scene_.show(wanted);
    draw();
  }

  void draw() {
    const int font = std::max(11, scene_.request().height / 52);
    std::string text;
    for (int f = 0; f < static_cast<int>(scene_.fields().size()); ++f)
      text += (f == field_ ? "> " : "   ") + scene_.fields()[static_cast<std::size_t>(f)] + "\n";
    text += "\nf next field, left/right time\nu at rest, e edges, l loads\nr fit, p picture, q end";
    list_->SetInput(text.c_str());
    list_->GetTextProperty()->SetFontSize(font);
    list_->GetTextProperty()->SetColor(0.13, 0.15, 0.18);
    list_->GetTextProperty()->SetVerticalJustificationToTop();
    list_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    list_->SetPosition(0.015, 0.985);
    scene_.renderer()->AddViewProp(list_);
    bar_->SetValue(scene_.step());
    scene_.renderer()->ResetCameraClippingRange();
    window_->Render();
  }

  void choose(int field) {
    const int count = static_cast<int>(scene_.fields().size());
    if (count == 0) return;
    field_ = (field % count + count) % count;
    scene_.request().field = scene_.fields()[static_cast<std::size_t>(field_)];
    scene_.show(scene_.step());
    draw();
  }

  /// A click on a line of the list chooses its field.
  void on_click() {
    double box[4];
    list_->GetBoundingBox(scene_.renderer(), box);
    int at[2];
    interactor_->GetEventPosition(at[0], at[1]);
    const int* size = window_->GetSize();
    const double left = 0.015 * size[0], top = 0.985 * size[1];
    if (at[0] < left || at[0] > left + box[1] - box[0] || at[1] > top) return;
    const double lines = static_cast<double>(scene_.fields().size()) + 4;
    const int line = static_cast<int>((top - at[1]) / ((box[3] - box[2]) / lines));
    if (line < static_cast<int>(scene_.fields().size())) choose(line);
  }

  void on_key() {
    const std::string key = interactor_->GetKeySym() == nullptr ? "" : interactor_->GetKeySym();
    Request& r = scene_.request();
    if (key == "Left" || key == "Right") return go_to(scene_.step() + (key == "Right" ? 1 : -1));
    if (key == "f" || key == "F") return choose(field_ + (key == "f" ? 1 : -1));
    if (key == "p") return write_picture(window_, "glisson.png");
    if (key == "r") scene_.fit_camera();
    if (key == "u") r.undeformed = !r.undeformed;
    if (key == "e") r.edges = !r.edges;
    if (key == "l") r.loads = !r.loads;
    if (key != "u" && key != "e" && key != "l" && key != "r") return;
    scene_.show(scene_.step());
    draw();
  }

  /// VTK's own single keys (wireframe, stereo, ...) would hide these.
  class Style : public vtkInteractorStyleTrackballCamera {
   public:
    static Style* New() { return new Style; }
    void OnChar() override {
      if (GetInteractor()->GetKeyCode() == 'q') vtkInteractorStyleTrackballCamera::OnChar();
    }
  };

  Scene& scene_;
  int field_ = 0;
  std::vector<std::pair<Window*, Action>> actions_ = reserved();
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<Style> style_;
  vtkNew<vtkSliderRepresentation2D> bar_;
  vtkNew<vtkSliderWidget> slider_;
  vtkNew<vtkTextActor> list_;

  /// Observers keep the addresses of entries.
  static std::vector<std::pair<Window*, Action>> reserved() {
    std::vector<std::pair<Window*, Action>> actions;
    actions.reserve(8);
    return actions;
  }
};

}  // namespace

void open_window(Scene& scene) { Window(scene).run(); }

}  // namespace glisson::viz
