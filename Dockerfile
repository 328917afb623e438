FROM debian:12
RUN apt-get update -q && apt-get install -y -q ca-certificates git
COPY . /ar3d
RUN git config --global --add safe.directory /ar3d && ln -s /ar3d/ar3d /usr/local/bin/ar3d && ar3d --version
WORKDIR /work
CMD ["ar3d", "study", "run", "quick"]
