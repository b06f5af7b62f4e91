// Loads the explorer and starts it. Stands behind what wasm-bindgen writes, in the same script.
(() => {
    "use strict";
    const own = document.currentScript;
    const at = (id) => document.getElementById(id);
    const before = at("before"), said = at("said"), bar = at("loaded");

    /// Says why there is no explorer, and shows what it would look like.
    const give_up = (sentence, can_try_again) => {
        before.hidden = false;
        said.textContent = sentence;
        bar.hidden = true;
        at("again").hidden = !can_try_again;
        const picture = at("picture");
        picture.src = "picture.png";
        picture.hidden = false;
    };
    at("again").addEventListener("click", () => location.reload());

    if (location.protocol === "file:") {
        give_up("This page needs a web server: browsers load no program from a file. scripts/web --serve is one.");
        return;
    }
    // A function that makes a vector of sixteen bytes, of the instructions that the program is built with.
    const vectors = new Uint8Array([
        0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
    ]);
    if (typeof WebAssembly !== "object" || !WebAssembly.validate(vectors)) {
        give_up("This browser does not run WebAssembly with vectors (SIMD): a newer one does.");
        return;
    }
    if (typeof DecompressionStream !== "function") {
        give_up("This browser cannot unpack the program (DecompressionStream): a newer one can.");
        return;
    }

    /// The bytes of the program, unpacked, while the bar shows how much has come.
    const fetched = async () => {
        const answer = await fetch(own.dataset.program);
        if (!answer.ok) throw new Error(`${own.dataset.program}: ${answer.status} ${answer.statusText}`);
        const all = Number(own.dataset.bytes);
        let come = 0;
        const megabytes = (bytes) => (bytes / 1048576).toFixed(1);
        const show = () => {
            bar.value = Math.min(come / all, 1);
            said.textContent = `Loading: ${megabytes(Math.min(come, all))} of ${megabytes(all)} MiB`;
        };
        bar.hidden = false;
        const reader = answer.body.getReader();
        const first = await reader.read();
        const head = first.value ?? new Uint8Array();
        // Some hosts unpack it on the way, by a header of their own.
        const is_packed = head[0] === 0x1f && head[1] === 0x8b;
        const body = new ReadableStream({
            async start(to) {
                come += head.length;
                show();
                to.enqueue(head);
            },
            async pull(to) {
                const { done, value } = await reader.read();
                if (done) return to.close();
                come += value.length;
                show();
                to.enqueue(value);
            },
        });
        const stream = is_packed ? body.pipeThrough(new DecompressionStream("gzip")) : body;
        return new Response(stream, { headers: { "Content-Type": "application/wasm" } });
    };

    /// Which of the pages of this browser this is, counted from 1: each keeps a session of its own. 0 where it cannot be told.
    const numbered = async () => {
        if (!navigator.locks) return 0;
        for (let number = 1; number <= 9; number += 1) {
            const is_own = await new Promise((resolve) => {
                navigator.locks.request(`brdf-explorer-${number}`, { ifAvailable: true }, (lock) => {
                    resolve(lock !== null);
                    // Held as long as the page stands.
                    return lock && new Promise(() => {});
                }).catch(() => resolve(false));
            });
            if (is_own) return number;
        }
        return 10;
    };

    const canvas = at("explorer");
    canvas.addEventListener("webglcontextlost", () => {
        give_up("The browser has taken the drawing context away. Reloading the page brings the session back.", true);
    });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    window.addEventListener("error", (event) => {
        if (/unreachable|RuntimeError/.test(String(event.message))) {
            give_up("The explorer has stopped by a fault of its own. Reloading the page brings the session back.", true);
        }
    });

    (async () => {
        let exports;
        try {
            const module = await WebAssembly.compileStreaming(await fetched());
            exports = await wasm_bindgen({ module_or_path: module });
        } catch (problem) {
            give_up(`The explorer could not be loaded (${problem.message ?? problem}).`, true);
            return;
        }
        said.textContent = "Starting";
        window.explorer_memory = exports.memory;
        try {
            await wasm_bindgen.start(canvas, await numbered());
        } catch (problem) {
            give_up(`This browser can draw neither by WebGPU nor by WebGL 2 (${problem.message ?? problem}).`, true);
            return;
        }
        before.hidden = true;
        document.documentElement.dataset.state = "started";
    })();
})();
