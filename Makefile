# make        builds ./editor
# make run    installs what a window needs, builds, and opens the showcase
#             (without a display: draws it to showcase.png)
# make test   installs what the tests need and runs everything
# make test-long  runs of minutes: ten thousand random commands, a thousand kills while saving, mistakes told
#             from dozens of pictures
# make bench  measures frames of the window, and writes docs/benchmarks.md
# make pictures  draws the pictures of README.md
# make check-assets  makes the characters, rigs, shapes, curves and poses in assets/ anew and compares
# make submission NAME="Ada Lovelace" SCENE=two.scene  builds, and makes the archive to hand in;
#             PICTURE=two.png in place of SCENE, ANSWERS=answers.md, OUT=hw2.tar.gz if wanted
# make web    installs what it needs and writes the page, the program in a browser, to target/web
# make serve  shows the page at http://127.0.0.1:8080 (PORT=8081 for another)
# make web-package  packs the page for a web server into editor-page.zip
# make test-web  installs what it needs and tries the page in a browser
# make lint   what must be clean before a change lands: format, clippy, documentation

CARGO ?= cargo

.PHONY: all editor run test test-stories test-others test-long bench check-assets lint pictures submission web serve \
	web-package test-web clean packages-run packages-test

all: editor

# Cargo knows best whether something changed.
editor:
	$(CARGO) build --release --locked
	@cp target/release/editor editor.new && mv -f editor.new editor

run: packages-run editor
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ]; then \
		./editor builtin:showcase; \
	else \
		./editor render builtin:showcase --size 1280x800 --samples 4 -o showcase.png && \
		echo "There is no display, so the showcase was drawn to showcase.png."; \
	fi

# Within a process only one thread has a context at a time, so the stories, nearly all of which draw, have a process of
# their own.
test: packages-test
	$(CARGO) test --locked --quiet --no-run
	@$(MAKE) --no-print-directory --jobs 2 test-stories test-others

test-stories:
	$(CARGO) test --locked --quiet --test all -- stories::

test-others:
	$(CARGO) test --locked --quiet -- --skip stories::

# With debug assertions egui keeps the source of every identifier, for good: no growth of the program's.
test-long: packages-test
	$(CARGO) test --config profile.dev.package.egui.debug-assertions=false --locked --quiet --test all -- --ignored long:: picture_pairs:: --nocapture

bench: packages-test
	$(CARGO) bench --locked --bench bench

check-assets:
	$(CARGO) test --locked --quiet --package make_assets

lint:
	$(CARGO) fmt --all --check
	$(CARGO) clippy --locked --workspace --all-targets -- -D warnings
	@if rustc --print target-libdir --target wasm32-unknown-unknown 2>/dev/null | xargs -r test -d; then \
		$(CARGO) clippy --locked --target wasm32-unknown-unknown --bin editor -- -D warnings; \
	fi
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --locked --no-deps --lib

pictures: packages-run editor
	@sh scripts/pictures.sh

# On a terminal, ./editor asks for what is missing.
submission: editor
	./editor submit $(if $(NAME),--name "$(NAME)") $(if $(SCENE),--scene "$(SCENE)") \
		$(if $(PICTURE),--picture "$(PICTURE)") $(if $(ANSWERS),--answers "$(ANSWERS)") \
		$(if $(OUT),-o "$(OUT)")

web:
	@CARGO="$(CARGO)" sh scripts/web.sh

serve: web
	@$(CARGO) run --locked --quiet --package make_web -- serve target/web $(PORT)

web-package: web
	@$(CARGO) run --locked --quiet --package make_web -- package target/web editor-page.zip
	@echo "The page is packed in editor-page.zip."

test-web:
	@sh scripts/packages.sh test-web
	@sh scripts/packages.sh run
	$(CARGO) build --locked
	@CARGO="$(CARGO)" sh scripts/web.sh test
	$(CARGO) test --locked --quiet --package make_web

packages-run:
	@sh scripts/packages.sh run

packages-test:
	@sh scripts/packages.sh test

clean:
	$(CARGO) clean
	rm -f editor showcase.png editor-page.zip
