//! The disk's clock along a journey.
//!
//! The rate is interpolated linearly between the keyframes that name it, and the time is its exact
//! integral. A journey moves the camera faster than light, so the camera's place counts, too
//! ([`Scene::disk_time_lead`](crate::scene::Scene::disk_time_lead)): the disk never seems to leap
//! or to run backward because the camera moves.

/// What the keyframes say about the disk's clock. Times are in seconds after the beginning.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Clock {
    /// Rates, in r_s/c per second, each with its time.
    pub(super) rates: Vec<(f64, f64)>,
    /// Values of `disk.time`, in r_s/c, each with the time at which the clock is set to it.
    pub(super) times: Vec<(f64, f64)>,
}

impl Clock {
    /// The rate at a time: linear between two keyframes, constant before the first and after the
    /// last. None if no keyframe names it.
    pub(super) fn rate_at(&self, time: f64) -> Option<f64> {
        let after = self.rates.partition_point(|(at, _)| *at <= time);
        let before = after.checked_sub(1).map(|index| self.rates[index]);
        match (before, self.rates.get(after)) {
            (Some((start, from)), Some((end, to))) => {
                Some(from + (to - from) * (time - start) / (end - start))
            }
            (Some((_, rate)), None) | (None, Some(&(_, rate))) => Some(rate),
            (None, None) => None,
        }
    }

    /// The time that passes on the disk's clock between two times of the journey, in r_s/c;
    /// negative if the second one is earlier. `rate` is that of a journey that names none.
    pub(super) fn passed(&self, from: f64, to: f64, rate: f64) -> f64 {
        if to < from {
            return -self.passed(to, from, rate);
        }
        let inner = self.rates.iter().map(|(time, _)| *time);
        let bends = inner.filter(|time| (from..to).contains(time)).chain([to]);
        let rate_at = |time| self.rate_at(time).unwrap_or(rate);
        let (mut start, mut sum) = (from, 0.0);
        for end in bends {
            // The rate is linear in between, so its mean is that of both ends.
            sum += 0.5 * (rate_at(start) + rate_at(end)) * (end - start);
            start = end;
        }
        sum
    }

    /// The last keyframe until a time that sets the clock: when, and to what.
    pub(super) fn set_before(&self, time: f64) -> Option<(f64, f64)> {
        let set = self.times.partition_point(|(at, _)| *at <= time);
        set.checked_sub(1).map(|index| self.times[index])
    }
}
