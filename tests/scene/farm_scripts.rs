//! The scripts in scripts/farm, with stand-ins for the program and the schedulers: what they run, and what
//! they do after each exit status. And the command lines of docs/FARM.md.

use lightfall::commands::cli;
use saphyr::{LoadableYamlNode, Yaml};
use serde_json::Value;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn script(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("scripts/farm")
        .join(name)
}

/// A folder of stand-ins, which note their arguments in the file `log`. That of the program ends with the
/// status that the file `status` says.
struct Stand {
    folder: tempfile::TempDir,
}

impl Stand {
    fn new(status: u8) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let stand = Self { folder };
        fs::write(stand.path("status"), status.to_string()).unwrap();
        let note = |name: &str, end: &str| {
            let here = stand.folder.path().display().to_string();
            let text = format!(
                "#!/usr/bin/env bash\nprintf '%s' {name} >>'{here}/log'\nprintf '|%s' \"$@\" >>'{here}/log'\n\
                 echo >>'{here}/log'\n{end}\n"
            )
            .replace("HERE", &here);
            fs::write(stand.path(name), text).unwrap();
            fs::set_permissions(stand.path(name), fs::Permissions::from_mode(0o755)).unwrap();
        };
        note("lightfall", "exit $(cat 'HERE/status')");
        note("scontrol", "");
        // Runs the line for the first part alone.
        note("parallel", "line=${!#}; bash -c \"${line//'{}'/1}\"");
        stand
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// A script that finds the stand-ins first.
    fn script(&self, name: &str) -> Command {
        let path = std::env::var("PATH").unwrap();
        let mut command = Command::new("bash");
        command
            .arg(script(name))
            .current_dir(self.folder.path())
            .env("PATH", format!("{}:{path}", self.folder.path().display()));
        command
    }

    fn run(&self, name: &str, arguments: &[&str], variables: &[(&str, &str)]) -> Output {
        self.script(name)
            .args(arguments)
            .env("PAUSE", "0")
            .env_remove("SLURM_JOB_GPUS")
            .envs(variables.iter().copied())
            .output()
            .unwrap()
    }

    /// What has been run since the last question.
    fn log(&self) -> String {
        let text = fs::read_to_string(self.path("log")).unwrap_or_default();
        fs::write(self.path("log"), "").unwrap();
        text
    }
}

#[test]
fn a_command_is_run_again_after_status_75_alone() {
    for (status, runs) in [(75, 4), (0, 1), (1, 1), (2, 1), (130, 1), (143, 1)] {
        let stand = Stand::new(status);
        let output = stand.run("again", &["lightfall", "render", "a b"], &[]);
        assert_eq!(output.status.code(), Some(status.into()));
        assert_eq!(
            stand.log(),
            "lightfall|render|a b\n".repeat(runs),
            "{status}"
        );
    }
    let stand = Stand::new(75);
    stand.run("again", &["lightfall"], &[("RESTARTS", "1")]);
    assert_eq!(stand.log().lines().count(), 2);
}

#[test]
fn a_command_that_is_run_again_is_asked_to_end_with_its_script() {
    let stand = Stand::new(0);
    let text = "#!/usr/bin/env bash\ntrap 'echo ended >>log; exit 143' TERM\necho begun >>log\nwhile :; do sleep 0.05; done\n";
    fs::write(stand.path("lightfall"), text).unwrap();
    let mut child = stand.script("again").arg("lightfall").spawn().unwrap();
    while !fs::read_to_string(stand.path("log")).is_ok_and(|log| log.contains("begun")) {
        assert!(child.try_wait().unwrap().is_none());
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let mut kill = Command::new("kill");
    kill.args(["-TERM", &child.id().to_string()]);
    assert!(kill.status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(143));
    assert_eq!(stand.log(), "begun\nended\n");
}

#[test]
fn a_task_of_a_slurm_array_draws_its_shard_and_goes_back_into_the_queue_after_75() {
    let task = [
        ("SLURM_ARRAY_TASK_ID", "2"),
        ("SLURM_ARRAY_TASK_COUNT", "4"),
        ("SLURM_ARRAY_JOB_ID", "77"),
        ("SLURM_JOB_ID", "79"),
    ];
    let run = |status: u8, more: &[(&str, &str)]| {
        let stand = Stand::new(status);
        let variables = [&task[..], more].concat();
        let output = stand.run(
            "lightfall.slurm",
            &["--preset", "2", "-o", "f.png"],
            &variables,
        );
        assert_eq!(output.status.code(), Some(status.into()));
        stand.log()
    };
    let drawn = "lightfall|render|--preset|2|-o|f.png|--resume|--shard|2/4\n";
    assert_eq!(run(0, &[]), drawn);
    assert_eq!(run(1, &[]), drawn);
    let again = format!("{drawn}scontrol|requeue|77_2\n");
    assert_eq!(run(75, &[]), again);
    assert_eq!(run(75, &[("SLURM_RESTART_COUNT", "2")]), again);
    assert_eq!(run(75, &[("SLURM_RESTART_COUNT", "3")]), drawn);
    assert_eq!(run(0, &[("SHARDS", "16")]), drawn.replace("2/4", "2/16"));
}

#[test]
fn gnu_parallel_gets_a_line_for_each_shard_that_a_shell_reads_back() {
    let stand = Stand::new(0);
    let arguments = ["16", "2", "--frames", "0..9", "-o", "my out/it's-##.png"];
    let output = stand.run("parallel", &arguments, &[]);
    assert!(output.status.success(), "{output:?}");
    let log = stand.log();
    let (parallel, program) = log.trim_end().split_once('\n').unwrap();
    assert!(
        parallel.starts_with("parallel|--jobs|2|--halt|soon,fail=1|--joblog|lightfall-shards.log|"),
        "{parallel}"
    );
    assert_eq!(
        program,
        "lightfall|render|--frames|0..9|-o|my out/it's-##.png|--resume|--shard|1/16"
    );
    let output = stand.run("parallel", &arguments, &[("CARDS", "yes")]);
    // The stand-in does not know the number of a job.
    assert!(!output.status.success());
    assert!(stand.log().contains("--gpu $(({%}-1)) "));
}

#[test]
fn pictures_are_verified_by_their_manifests() {
    let stand = Stand::new(0);
    let hash = lightfall_platform::storage::hash_of_text;
    let row = |frame: u32, text: &str| {
        let file = format!("f-{frame:02}.png");
        fs::write(stand.path(&file), text).unwrap();
        let row = serde_json::json!({
            "frame": frame, "file": file, "sha256": hash(text), "bytes": text.len(), "seconds": null,
            "exposure_ev": 1.5, "preset_sha256": hash(""), "version": "0.1.0", "commit": null, "adapter": null,
            "driver": null, "backend": null, "pci": null, "host": null,
        });
        format!("{row}\n")
    };
    fs::write(stand.path("f.1-of-2.jsonl"), row(0, "a") + &row(2, "c")).unwrap();
    fs::write(stand.path("f.2-of-2.jsonl"), row(1, "b")).unwrap();
    let files = ["f.1-of-2.jsonl", "f.2-of-2.jsonl"];
    let output = stand.run("verify", &files, &[]);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{output:?}");
    assert!(said.starts_with("3 frames"), "{said}");
    // The program reads these rows, too.
    assert!(lightfall_picture::Manifest::open(&stand.path(files[0])).is_ok());
    fs::write(stand.path("f-02.png"), "C").unwrap();
    assert!(!stand.run("verify", &files, &[]).status.success());
    fs::write(stand.path("f-02.png"), "c").unwrap();
    fs::write(stand.path(files[1]), "mine\n").unwrap();
    assert!(!stand.run("verify", &files, &[]).status.success());
}

/// Asserts that the program reads a command line.
fn expect_options(line: &str) {
    let words = shlex::split(line).unwrap();
    if let Err(error) = cli::read(words) {
        panic!("{line}\n{error}");
    }
}

#[test]
fn the_program_reads_the_command_lines_of_the_document_and_of_the_job_descriptions() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(root.join("docs/FARM.md")).unwrap();
    let mut lines = 0;
    for line in text
        .lines()
        .filter_map(|line| line.strip_prefix("    lightfall "))
    {
        let line = line.split("  #").next().unwrap_or_default();
        expect_options(&format!("lightfall {line}"));
        lines += 1;
    }
    assert!(lines >= 5, "{lines} command lines");

    let batch: Value =
        serde_json::from_str(&fs::read_to_string(script("aws-batch.json")).unwrap()).unwrap();
    let kubernetes = fs::read_to_string(script("kubernetes.yaml")).unwrap();
    let slurm = fs::read_to_string(script("lightfall.slurm")).unwrap();
    let shell = batch["containerProperties"]["command"][2].as_str().unwrap();
    let (_, line) = shell.split_once("exec ").unwrap();
    expect_options(&line.replace("$((AWS_BATCH_JOB_ARRAY_INDEX + 1))", "1"));
    let (_, line) = kubernetes.split_once("- exec ").unwrap();
    let (line, _) = line.split_once("resources:").unwrap();
    expect_options(
        &line
            .replace("$((JOB_COMPLETION_INDEX + 1))", "1")
            .replace('\n', " "),
    );
    let (_, line) = slurm.split_once("lightfall.slurm --preset").unwrap();
    let line = line.lines().next().unwrap();
    expect_options(&format!("lightfall render --preset{line}"));
    // Both retry after the same statuses.
    let retried = batch["retryStrategy"]["evaluateOnExit"].as_array().unwrap();
    for status in ["75", "143"] {
        let is_retried = |rule: &Value| rule["onExitCode"] == status && rule["action"] == "RETRY";
        assert!(retried.iter().any(is_retried), "{status}");
    }
    assert!(kubernetes.contains("operator: NotIn, values: [75, 143]"));
    for name in ["openjd.yaml", "kubernetes.yaml"] {
        let text = fs::read_to_string(script(name)).unwrap();
        assert_eq!(Yaml::load_from_str(&text).unwrap().len(), 1, "{name}");
    }
}
