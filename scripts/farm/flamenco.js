// A job type of Flamenco 3: a task draws a chunk of frames. Put this file into the folder `scripts` of the
// manager, and choose the type "Lightfall" when a job is submitted.
const JOB_TYPE = {
  label: "Lightfall",
  description: "Draws the numbered pictures of a journey with Lightfall",
  settings: [
    { key: "program", type: "string", default: "lightfall", visible: "submission",
      description: "The program, as the workers find it" },
    { key: "options", type: "string", required: true, default: "--preset 2 --size 1920x1080 --cells off", visible: "submission",
      description: "Options of `lightfall render`, with single spaces between words" },
    { key: "frames", type: "string", required: true, default: "0-299", visible: "submission",
      description: "Frames, as in 0-9,20,30-300" },
    { key: "chunk_size", type: "int32", default: 25, visible: "submission", description: "Frames in a task" },
    { key: "fps", type: "float", default: 24, visible: "submission" },
    { key: "output", type: "string", subtype: "file_path", required: true, default: "/shared/flight-####.png", visible: "submission",
      description: "The pictures, in a folder that all workers share" },
  ],
};

function compileJob(job) {
  const settings = job.settings;
  for (const chunk of frameChunker(settings.frames, settings.chunk_size)) {
    const task = author.Task(`draw-${chunk}`, "misc");
    task.addCommand(author.Command("exec", {
      exe: settings.program,
      args: ["render", ...settings.options.split(" "), "--frames", chunk, "--fps", String(settings.fps), "--resume", "-o", settings.output],
    }));
    job.addTask(task);
  }
}
