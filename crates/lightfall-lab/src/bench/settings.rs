//! The methods that can trace a scene, and the settings at which each is measured.

use glam::UVec2;
use lightfall_gpu::GpuScene;
use lightfall_model::scene::{AccuracySetting, ArticleQuality, Frame, Method, Scene};

/// Step scales of the article's methods, from the fastest to a scale at which 768 steps do not
/// suffice. Those of the article's own qualities, 1.55, 0.85 and 0.45, come with their budgets of
/// 128, 256 and 768 steps, the others with the scene's.
const STEP_SCALES: [f64; 8] = [3.0, 1.55, 0.85, 0.45, 0.25, 0.14, 0.08, 0.045];
/// The article's own.
const FEW_STEP_SCALES: [f64; 3] = [1.55, 0.85, 0.45];
/// Maximum errors of mino, in pixels.
const ERRORS: [f64; 8] = [1.0, 0.3, 0.1, 0.05, 0.01, 0.003, 0.001, 0.0001];
/// The fastest, the default, and the most exact.
const FEW_ERRORS: [f64; 3] = [1.0, 0.05, 0.0001];

/// A method at one of its settings.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Key of the field that is set, if the method has a setting.
    pub key: Option<&'static str>,
    /// Value of the field; NaN if there is none.
    pub value: f64,
    /// Which of the article's qualities it is, for its own methods.
    pub quality: Option<ArticleQuality>,
    /// The scene with the method and the setting.
    pub scene: Scene,
    /// Whether it is the scene's own setting.
    pub own: bool,
    /// Whether `auto` draws the scene with this method and setting.
    pub auto: bool,
}

impl Setting {
    /// The method with its setting, as in tables.
    pub fn label(&self) -> String {
        let quality = self.quality.map(ArticleQuality::word);
        let setting = setting_label(quality, self.key.map(|_| self.value));
        label(self.scene.method.word(), &setting)
    }
}

/// A method with its setting, as in tables.
pub(super) fn label(method: &str, setting: &str) -> String {
    format!("{method} {setting}").trim_end().to_owned()
}

/// The setting of a method: the article's word for it, else its value; empty if there is none.
pub(super) fn setting_label(quality: Option<&str>, value: Option<f64>) -> String {
    let value = value.map(|value| value.to_string());
    quality.map(str::to_owned).or(value).unwrap_or_default()
}

/// The methods that can trace a scene on the GPU.
pub fn methods_for(scene: &Scene) -> Vec<Method> {
    let mut methods = Method::on_gpu();
    methods.retain(|method| scene.hole.spin == 0.0 || method.properties().spins);
    methods
}

/// Those of these methods that can trace a scene on the GPU.
pub(crate) fn able_methods(scene: &Scene, methods: &[Method]) -> impl Iterator<Item = Method> {
    let able = methods_for(scene).into_iter();
    able.filter(|method| methods.contains(method))
}

/// The settings of a method for a scene, few or many. Settings that make no difference are left
/// out.
pub fn settings(scene: &Scene, method: Method, few: bool) -> Vec<Setting> {
    let subject = scene;
    let kind = method.properties().setting;
    let set = |key: Option<&'static str>, value: f64, change: fn(&mut Scene, f64)| {
        let mut scene = subject.with_method(method);
        change(&mut scene, value);
        let own = scene.quality == subject.quality;
        let steps = kind == AccuracySetting::StepScale;
        Setting {
            key,
            value,
            quality: scene.quality.article().filter(|_| steps),
            scene,
            own,
            auto: false,
        }
    };
    let series = |key, own: f64, values: &[f64], change: fn(&mut Scene, f64)| {
        let values = values.iter().map(|value| set(Some(key), *value, change));
        let own = set(Some(key), own, |_, _| {});
        [own].into_iter().chain(values).collect()
    };
    let mut all: Vec<Setting> = match kind {
        AccuracySetting::StepScale => {
            let values: &[f64] = if few { &FEW_STEP_SCALES } else { &STEP_SCALES };
            let own = scene.quality.step_scale;
            series("quality.step_scale", own, values, |scene, value| {
                let mut named = ArticleQuality::ALL.into_iter();
                match named.find(|named| named.step_scale() == value) {
                    Some(named) => scene.quality = scene.quality.with_steps_of(named),
                    None => scene.quality.step_scale = value,
                }
            })
        }
        AccuracySetting::MaxError => {
            let values: &[f64] = if few { &FEW_ERRORS } else { &ERRORS };
            let own = scene.quality.max_error_px;
            series("quality.max_error_px", own, values, |scene, value| {
                scene.quality.max_error_px = value;
            })
        }
        AccuracySetting::None => vec![set(None, f64::NAN, |_, _| {})],
    };
    let numbers = |setting: &Setting| {
        let frame = Frame::of(&setting.scene).with_whole(UVec2::new(1920, 1080));
        GpuScene::new(&setting.scene, &frame).ok()
    };
    let mut kept: Vec<Option<GpuScene>> = Vec::new();
    all.retain(|setting| {
        let numbers = numbers(setting);
        let new = !kept.contains(&numbers);
        kept.push(numbers);
        new
    });
    if let Some(first) = all.first_mut().filter(|_| method == Method::BEST) {
        first.auto = true;
    }
    all
}
