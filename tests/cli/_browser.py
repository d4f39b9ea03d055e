"""A page in a headless Chromium, asked questions by a script of the test."""
import json
import pathlib
import re
import shutil
import subprocess

_HEAD = """<script>
window.complaints = [];
window.addEventListener("error", (event) => complaints.push(String(event.message)));
window.addEventListener("unhandledrejection", (event) => complaints.push(String(event.reason)));
console.error = (...words) => complaints.push(words.join(" "));
console.warn = console.error;
</script>"""

_TAIL = """<script>
(async () => {
  const answer = {};
  try { await view.ready; await (async (page, answer) => { %s })(view.page, answer); }
  catch (error) { complaints.push(String(error.stack || error)); }
  answer.complaints = complaints;
  const element = document.createElement("pre");
  element.id = "answer";
  element.textContent = JSON.stringify(answer);
  document.body.append(element);
})();
</script>"""


def ask(page, questions, work_folder, size=(640, 480), shot=None):
    """Loads a page, runs `questions` (the body of an async function of `page` and `answer`), and
    returns what they put into `answer`; `complaints` are errors and words on the console.
    """
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not browser:
        raise SystemExit("this test needs Chromium: install it (Debian: apt-get install chromium)")
    folder = pathlib.Path(work_folder)
    text = pathlib.Path(page).read_text()
    asked = folder / "asked.html"
    asked.write_text(text.replace("<head>", "<head>" + _HEAD, 1).replace("</body>", _TAIL % questions + "</body>", 1))
    command = [browser, "--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
               "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", "--no-first-run", "--disable-quic",
               "--disable-background-networking", "--disable-component-update", "--disable-sync",
               f"--user-data-dir={folder / 'profile'}", f"--window-size={size[0]},{size[1]}",
               "--timeout=60000", "--virtual-time-budget=600000"]
    target = asked.resolve().as_uri()
    if shot:
        subprocess.run([*command, "--hide-scrollbars", f"--screenshot={shot}", target], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)
    result = subprocess.run([*command, "--dump-dom", target], capture_output=True, text=True, timeout=300)
    found = re.search(r'<pre id="answer">(.*?)</pre>', result.stdout, re.S)
    if not found:
        raise SystemExit("the browser gave no answer:\n" + result.stdout[-500:] + result.stderr[-2000:])
    unescaped = found.group(1).replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", '"').replace("&amp;", "&")
    return json.loads(unescaped)
